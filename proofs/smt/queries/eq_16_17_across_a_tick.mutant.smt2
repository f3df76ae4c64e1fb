; EQ-16/17, across a tick: from inside a tick to its upper end the potential rises by the held force times the way
; the linear spring's does not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x1
(assert (and (<= (to_real floor2) x1) (< x1 (+ (to_real floor2) 1))))
(assert (= x1 (+ (to_real floor1) 1.0)))
(assert (= (to_real floor2) x1))
(assert (= x0 (/ 1.0 2.0)))
; what would contradict the goal
(assert (not (= (- (/ (* x1 x1) 2) (/ (* x0 x0) 2)) (- (* (- (+ (to_real floor1) (/ 1.0 2))) (- x1 x0))))))
(check-sat)
