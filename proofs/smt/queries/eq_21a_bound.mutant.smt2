; EQ-21a, bound: E_gq is at most ½|D|
; it can be above ¼|D|
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x1
(assert (and (<= (to_real floor2) x1) (< x1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (- (to_real floor2) (to_real floor1)))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
; what would contradict the goal
(assert (not (<= (- (* (- (- x0 (to_real floor1)) (/ 1.0 2)) (- (to_real floor2) (to_real floor1))) (/ (* (- (- x1 (to_real floor2)) (- x0 (to_real floor1))) (- (- x1 (to_real floor2)) (- x0 (to_real floor1)))) 2)) (/ (/ def4 2) 2))))
(check-sat)
