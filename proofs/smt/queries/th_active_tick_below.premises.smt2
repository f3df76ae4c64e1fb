; TH-ACTIVE, tick below: for whole n and 0 < a ≤ 1 the lower end lies in tick n − 1
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const n Real)
(declare-const a Real)
(declare-const floor1 Int) ; floor of n
(assert (and (<= (to_real floor1) n) (< n (+ (to_real floor1) 1))))
(assert (= (to_real floor1) n))
(assert (> a 0.0))
(assert (<= a 1.0))
(check-sat)
