; EQ-16/17, within a tick: within a tick the potential rises by the held force times the way
; within a tick the potential rises by the held force times the way
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(declare-const floor2 Real) ; floor of x1
(assert (and (<= floor2 x1) (< x1 (+ floor2 1))))
(assert (= floor1 floor2))
; what would contradict the goal
(assert (not (= (- (+ (/ (* x1 x1) 2) (/ (* (- x1 floor2) (- 1 (- x1 floor2))) 2)) (+ (/ (* x0 x0) 2) (/ (* (- x0 floor1) (- 1 (- x0 floor1))) 2))) (- (* (- (+ floor1 (/ 1 2))) (- x1 x0))))))
(check-sat)
