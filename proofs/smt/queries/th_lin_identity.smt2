; TH-LIN, identity: the formula is the definition (18) against the linear spring
; the formula is the definition (18) against the linear spring
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
; what would contradict the goal
(assert (not (= (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 floor1) (- x0 floor1))) 1)) 2) (- (+ (* (- (+ floor1 (/ 1 2))) (- x1 x0)) (/ (* x1 x1) 2)) (/ (* x0 x0) 2)))))
(check-sat)
