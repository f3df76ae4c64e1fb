; TH-COUNTS, force: under a force between two ends generated energy is between its values under these
; not always the first way round
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const F0 Real)
(declare-const F Real)
(declare-const F1 Real)
(declare-const x Real)
(declare-const y Real)
(declare-const floor1 Int) ; floor of x
(assert (and (<= (to_real floor1) x) (< x (+ (to_real floor1) 1))))
(assert (<= F0 F))
(assert (<= F F1))
; what would contradict the goal
(assert (not (and (<= (+ (* (- F0 (- (+ (to_real floor1) (/ 1.0 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x (to_real floor1)) (- x (to_real floor1)))) 1.0)) 2)) (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x (to_real floor1)) (- x (to_real floor1)))) 1.0)) 2))) (<= (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x (to_real floor1)) (- x (to_real floor1)))) 1.0)) 2)) (+ (* (- F1 (- (+ (to_real floor1) (/ 1.0 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x (to_real floor1)) (- x (to_real floor1)))) 1.0)) 2))))))
(check-sat)
