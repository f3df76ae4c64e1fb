; TH-UNI, bound: the wall on one side, behind an encoder, generates at most ½d² + ½|d|
; more than ½d²
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(define-fun def2 () Real (+ (to_real floor1) (/ 1.0 2)))
(define-fun def3 () Real (ite (>= def2 0.0) def2 0.0))
(define-fun def4 () Real (ite (>= x1 0.0) x1 0.0))
(define-fun def5 () Real (ite (>= x0 0.0) x0 0.0))
; what would contradict the goal
(assert (not (<= (- (+ (* (- def3) (- x1 x0)) (- (* x1 def4) (/ (* def4 def4) 2))) (- (* x0 def5) (/ (* def5 def5) 2))) (/ (* (- x1 x0) (- x1 x0)) 2))))
(check-sat)
