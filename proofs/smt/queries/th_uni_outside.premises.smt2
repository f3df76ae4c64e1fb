; TH-UNI, outside: outside it pushes with nothing, and stores nothing
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(assert (<= (to_real floor1) (- 1.0)))
(assert (<= x0 0.0))
(check-sat)
