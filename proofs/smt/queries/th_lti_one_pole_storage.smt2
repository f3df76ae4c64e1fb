; TH-LTI, one pole storage: what the storage w²/(2(1 − a)) of the filter gains over a sample is a polynomial
; what the storage w²/(2(1 − a)) of the filter gains over a sample is a polynomial
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const a Real)
(declare-const stored Real)
(declare-const w Real)
(declare-const x1 Real)
(declare-const x0 Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
(assert (= (* stored (+ (- 1 a) (- 1 a))) (- (* (+ (* a w) (* (- 1 a) (- x1 x0))) (+ (* a w) (* (- 1 a) (- x1 x0)))) (* w w))))
; what would contradict the goal
(assert (not (= stored (+ (/ (- (* (- 1 a) (* (- x1 x0) (- x1 x0))) (* (+ 1 a) (* w w))) 2) (* (* a w) (- x1 x0))))))
(check-sat)
