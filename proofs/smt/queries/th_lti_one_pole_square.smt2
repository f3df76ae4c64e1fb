; TH-LTI, one pole square: twice what Dw + D²(1 − a)/(1 + a) has to spare beyond that is (1 + a) times a square
; twice what Dw + D²(1 − a)/(1 + a) has to spare beyond that is (1 + a) times a square
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const a Real)
(declare-const share Real)
(declare-const stored Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const w Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
(assert (= (* share (+ 1 a)) (- 1 a)))
(assert (= stored (+ (/ (- (* (- 1 a) (* (- x1 x0) (- x1 x0))) (* (+ 1 a) (* w w))) 2) (* (* a w) (- x1 x0)))))
; what would contradict the goal
(assert (not (= (+ (- (+ (* w (- x1 x0)) (* share (* (- x1 x0) (- x1 x0)))) stored) (- (+ (* w (- x1 x0)) (* share (* (- x1 x0) (- x1 x0)))) stored)) (* (+ 1 a) (* (+ w (* share (- x1 x0))) (+ w (* share (- x1 x0))))))))
(check-sat)
