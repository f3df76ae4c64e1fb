; TH-COUNTS, end position: generated energy at a position between two ends is between its values at these and where the wall balances the force
; not between those at the ends alone
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const lo Real)
(declare-const x Real)
(declare-const hi Real)
(declare-const F Real)
(declare-const e Real)
(declare-const floor1 Int) ; floor of e
(assert (and (<= (to_real floor1) e) (< e (+ (to_real floor1) 1))))
(define-fun def2 () Real (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- lo e)) (/ (* (- lo e) (- (+ (- lo e) (+ (- e (to_real floor1)) (- e (to_real floor1)))) 1.0)) 2)))
(define-fun def3 () Real (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- hi e)) (/ (* (- hi e) (- (+ (- hi e) (+ (- e (to_real floor1)) (- e (to_real floor1)))) 1.0)) 2)))
(define-fun def4 () Real (ite (<= def2 def3) def2 def3))
(define-fun def5 () Real (ite (>= def2 def3) def2 def3))
(assert (<= lo x))
(assert (<= x hi))
(assert (= lo (/ 0.0 1.0)))
(assert (= hi (/ 2.0 1.0)))
(assert (= x (/ 1.0 1.0)))
(assert (= F (/ (- 1.0) 1.0)))
(assert (= e (/ 0.0 1.0)))
; what would contradict the goal
(assert (not (and (<= def4 (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- x e)) (/ (* (- x e) (- (+ (- x e) (+ (- e (to_real floor1)) (- e (to_real floor1)))) 1.0)) 2))) (<= (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- x e)) (/ (* (- x e) (- (+ (- x e) (+ (- e (to_real floor1)) (- e (to_real floor1)))) 1.0)) 2)) def5))))
(check-sat)
