; TH-UNI, bound: the wall on one side, behind an encoder, generates at most ½d² + ½|d|
; the wall on one side, behind an encoder, generates at most ½d² + ½|d|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(define-fun def2 () Real (+ floor1 (/ 1 2)))
(define-fun def3 () Real (ite (>= def2 0) def2 0))
(define-fun def4 () Real (ite (>= x1 0) x1 0))
(define-fun def5 () Real (ite (>= x0 0) x0 0))
(define-fun def6 () Real (- x1 x0))
(define-fun def7 () Real (ite (>= def6 0) def6 (- def6)))
; what would contradict the goal
(assert (not (<= (- (+ (* (- def3) (- x1 x0)) (- (* x1 def4) (/ (* def4 def4) 2))) (- (* x0 def5) (/ (* def5 def5) 2))) (/ (* def7 (+ def7 1)) 2))))
(check-sat)
