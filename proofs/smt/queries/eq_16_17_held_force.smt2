; EQ-16/17, held force: the force is held within half a tick of the position
; the force is held within half a tick of the position
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x Real)
(declare-const floor1 Real) ; floor of x
(assert (and (<= floor1 x) (< x (+ floor1 1))))
(define-fun def2 () Real (+ (- (+ floor1 (/ 1 2))) x))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
; what would contradict the goal
(assert (not (<= def3 (/ 1 2))))
(check-sat)
