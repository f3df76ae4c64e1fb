; TH-SMOOTH, step: without an encoder a step generates ½d², which is all that it costs
; without an encoder a step generates ½d², which is all that it costs
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x0 Real)
(declare-const x1 Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
; what would contradict the goal
(assert (not (and (= (- (+ (* (- x0) (- x1 x0)) (/ (* x1 x1) 2)) (/ (* x0 x0) 2)) (/ (* (- x1 x0) (- x1 x0)) 2)) (= (- (+ (* (- x0) (- x1 x0)) (/ (* x1 x1) 2)) (/ (* x0 x0) 2)) (* def2 (+ (* (* (* 1 1) (+ (/ 1 2) 0)) def2) 0))))))
(check-sat)
