; ERR-19-start, as printed: the bound holds from any instant of an interval
; as printed: refuted by every model
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const sample Real)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Int) ; floor of sample
(assert (and (<= (to_real floor1) sample) (< sample (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x0
(assert (and (<= (to_real floor2) x0) (< x0 (+ (to_real floor2) 1))))
(declare-const floor3 Int) ; floor of x1
(assert (and (<= (to_real floor3) x1) (< x1 (+ (to_real floor3) 1))))
(define-fun def4 () Real (- x1 x0))
(define-fun def5 () Real (ite (>= def4 0) def4 (- def4)))
(assert (<= sample x0))
(assert (<= x0 x1))
(assert (<= (- x1 sample) 1.0))
(assert (= (to_real floor1) 0.0))
(assert (= (to_real floor2) 1.0))
(assert (= (to_real floor3) 1.0))
; what would contradict the goal
(assert (not (<= (- (+ (* (- (+ (to_real floor1) (/ 1.0 2))) (- x1 x0)) (/ (* x1 x1) 2)) (/ (* x0 x0) 2)) (/ (* def5 (+ def5 1.0)) 2))))
(check-sat)
