; TH-INTERVAL, first half: whatever the step, E_gᴸ is at most ½d² + ½|d|
; whatever the step, E_gᴸ is at most ½d² + ½|d|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const dtau Real)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(define-fun def2 () Real (- x1 x0))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
(assert (> dtau 0))
; what would contradict the goal
(assert (not (<= (+ (* (- (- (+ floor1 (/ 1 2))) (- (+ floor1 (/ 1 2)))) (- x1 x0)) (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 floor1) (- x0 floor1))) 1)) 2)) (/ (* def3 (+ def3 1)) 2))))
(check-sat)
