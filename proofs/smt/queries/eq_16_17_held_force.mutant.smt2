; EQ-16/17, held force: the force is held within half a tick of the position
; not within a third
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const x Real)
(declare-const floor1 Int) ; floor of x
(assert (and (<= (to_real floor1) x) (< x (+ (to_real floor1) 1))))
(define-fun def2 () Real (+ (- (+ (to_real floor1) (/ 1.0 2))) x))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
; what would contradict the goal
(assert (not (<= def3 (/ 1.0 3.0))))
(check-sat)
