; TH-COUNTS, start position: generated energy at a position between two ends is between its values at these and where the wall balances the force
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
(declare-const floor1 Int) ; floor of lo
(assert (and (<= (to_real floor1) lo) (< lo (+ (to_real floor1) 1))))
(define-fun def2 () Real (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- e lo)) (/ (* (- e lo) (- (+ (- e lo) (+ (- lo (to_real floor1)) (- lo (to_real floor1)))) 1.0)) 2)))
(declare-const floor3 Int) ; floor of hi
(assert (and (<= (to_real floor3) hi) (< hi (+ (to_real floor3) 1))))
(define-fun def4 () Real (+ (* (- F (- (+ (to_real floor3) (/ 1.0 2)))) (- e hi)) (/ (* (- e hi) (- (+ (- e hi) (+ (- hi (to_real floor3)) (- hi (to_real floor3)))) 1.0)) 2)))
(define-fun def5 () Real (ite (<= def2 def4) def2 def4))
(declare-const floor6 Int) ; floor of x
(assert (and (<= (to_real floor6) x) (< x (+ (to_real floor6) 1))))
(define-fun def7 () Real (ite (>= def2 def4) def2 def4))
(assert (<= lo x))
(assert (<= x hi))
(assert (= lo (/ 0.0 1.0)))
(assert (= hi (/ 2.0 1.0)))
(assert (= x (/ 1.0 1.0)))
(assert (= F (/ (- 1.0) 1.0)))
(assert (= e (/ 0.0 1.0)))
; what would contradict the goal
(assert (not (and (<= def5 (+ (* (- F (- (+ (to_real floor6) (/ 1.0 2)))) (- e x)) (/ (* (- e x) (- (+ (- e x) (+ (- x (to_real floor6)) (- x (to_real floor6)))) 1.0)) 2))) (<= (+ (* (- F (- (+ (to_real floor6) (/ 1.0 2)))) (- e x)) (/ (* (- e x) (- (+ (- e x) (+ (- x (to_real floor6)) (- x (to_real floor6)))) 1.0)) 2)) def7))))
(check-sat)
