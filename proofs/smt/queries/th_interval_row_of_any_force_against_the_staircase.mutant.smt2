; TH-INTERVAL, row of any force against the staircase: against the quantized law it is the work and the change of the staircase's potential
; the two accounts differ
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const L Real)
(declare-const u Real)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x1
(assert (and (<= (to_real floor2) x1) (< x1 (+ (to_real floor2) 1))))
(assert (> L 0.0))
; what would contradict the goal
(assert (not (= (+ (* (- u (- (+ (to_real floor1) (/ 1.0 2)))) (- x1 x0)) (/ (* (- (to_real floor2) (to_real floor1)) (- (+ (- (to_real floor2) (to_real floor1)) (+ (- x1 (to_real floor2)) (- x1 (to_real floor2)))) 1.0)) 2)) (+ (* (- u (- (+ (to_real floor1) (/ 1.0 2)))) (- x1 x0)) (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 (to_real floor1)) (- x0 (to_real floor1)))) 1.0)) 2)))))
(check-sat)
