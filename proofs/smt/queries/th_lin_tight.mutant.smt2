; TH-LIN, tight: downwards from a tick the bound is reached; upwards it is missed by (1 − ρ₀)d
; upwards the bound is never reached
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(define-fun def2 () Real (- x1 x0))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
(assert (or (> 0.0 (- x1 x0)) (> (- x1 x0) 0.0)))
; what would contradict the goal
(assert (not (= (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 (to_real floor1)) (- x0 (to_real floor1)))) 1.0)) 2) (/ (* def3 (+ def3 1.0)) 2))))
(check-sat)
