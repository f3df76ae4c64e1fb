; TH-COUNTS, force: under a force between two ends generated energy is between its values under these
; under a force between two ends generated energy is between its values under these
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const F0 Real)
(declare-const F Real)
(declare-const F1 Real)
(declare-const x Real)
(declare-const y Real)
(declare-const floor1 Real) ; floor of x
(assert (and (<= floor1 x) (< x (+ floor1 1))))
(assert (<= F0 F))
(assert (<= F F1))
; what would contradict the goal
(assert (not (or (and (<= (+ (* (- F0 (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2)) (+ (* (- F (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2))) (<= (+ (* (- F (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2)) (+ (* (- F1 (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2)))) (and (<= (+ (* (- F1 (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2)) (+ (* (- F (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2))) (<= (+ (* (- F (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2)) (+ (* (- F0 (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2)))))))
(check-sat)
