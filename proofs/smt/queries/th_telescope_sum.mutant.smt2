; TH-TELESCOPE, sum: the differences over two runs add up to that of both
; the middle does not drop out when its sign is lost
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const x2 Real)
(declare-const floor1 Int) ; floor of x1
(assert (and (<= (to_real floor1) x1) (< x1 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x0
(assert (and (<= (to_real floor2) x0) (< x0 (+ (to_real floor2) 1))))
(declare-const floor3 Int) ; floor of x2
(assert (and (<= (to_real floor3) x2) (< x2 (+ (to_real floor3) 1))))
; what would contradict the goal
(assert (not (= (- (- (/ (* (- x1 (to_real floor1)) (- 1.0 (- x1 (to_real floor1)))) 2) (/ (* (- x0 (to_real floor2)) (- 1.0 (- x0 (to_real floor2)))) 2)) (- (/ (* (- x2 (to_real floor3)) (- 1.0 (- x2 (to_real floor3)))) 2) (/ (* (- x1 (to_real floor1)) (- 1.0 (- x1 (to_real floor1)))) 2))) (- (/ (* (- x2 (to_real floor3)) (- 1.0 (- x2 (to_real floor3)))) 2) (/ (* (- x0 (to_real floor2)) (- 1.0 (- x0 (to_real floor2)))) 2)))))
(check-sat)
