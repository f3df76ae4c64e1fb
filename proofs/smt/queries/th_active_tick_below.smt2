; TH-ACTIVE, tick below: for whole n and 0 < a ≤ 1 the lower end lies in tick n − 1
; for whole n and 0 < a ≤ 1 the lower end lies in tick n − 1
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status unsat)
(declare-const n Real)
(declare-const a Real)
(declare-const floor1 Int) ; floor of n
(assert (and (<= (to_real floor1) n) (< n (+ (to_real floor1) 1))))
(define-fun def2 () Real (- n a))
(declare-const floor3 Int) ; floor of def2
(assert (and (<= (to_real floor3) def2) (< def2 (+ (to_real floor3) 1))))
(assert (= (to_real floor1) n))
(assert (> a 0.0))
(assert (<= a 1.0))
; what would contradict the goal
(assert (not (= (to_real floor3) (- n 1.0))))
(check-sat)
