; EQ-16/17, within a tick: within a tick the potential rises by the held force times the way
; across a tick it does not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x1
(assert (and (<= (to_real floor1) x1) (< x1 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x0
(assert (and (<= (to_real floor2) x0) (< x0 (+ (to_real floor2) 1))))
; what would contradict the goal
(assert (not (= (- (+ (/ (* x1 x1) 2) (/ (* (- x1 (to_real floor1)) (- 1.0 (- x1 (to_real floor1)))) 2)) (+ (/ (* x0 x0) 2) (/ (* (- x0 (to_real floor2)) (- 1.0 (- x0 (to_real floor2)))) 2))) (- (* (- (+ (to_real floor2) (/ 1.0 2))) (- x1 x0))))))
(check-sat)
