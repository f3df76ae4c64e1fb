; TH-COUNTS, edge of the end: while the end moves generated energy is ½d² + (F + ξ₀)d
; it is not −½d² + (F + ξ₀)d
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const F Real)
(declare-const x Real)
(declare-const y Real)
(declare-const floor1 Int) ; floor of x
(assert (and (<= (to_real floor1) x) (< x (+ (to_real floor1) 1))))
; what would contradict the goal
(assert (not (= (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x (to_real floor1)) (- x (to_real floor1)))) 1.0)) 2)) (+ (* (- (/ 1.0 2)) (* (- y x) (- y x))) (* (+ F x) (- y x))))))
(check-sat)
