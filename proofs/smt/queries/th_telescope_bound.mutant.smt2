; TH-TELESCOPE, bound: from any start to any end the change of ½ρ(1 − ρ) is within 1/8
; it is not within 1/9
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Int) ; floor of x1
(assert (and (<= (to_real floor1) x1) (< x1 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x0
(assert (and (<= (to_real floor2) x0) (< x0 (+ (to_real floor2) 1))))
(define-fun def3 () Real (- (/ (* (- x1 (to_real floor1)) (- 1.0 (- x1 (to_real floor1)))) 2) (/ (* (- x0 (to_real floor2)) (- 1.0 (- x0 (to_real floor2)))) 2)))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(assert (= x0 (/ 0.0 1.0)))
(assert (= x1 (/ 1.0 2.0)))
; what would contradict the goal
(assert (not (<= def4 (/ 1.0 9.0))))
(check-sat)
