; TH-COUNTS, end position: generated energy at a position between two ends is between its values at these and where the wall balances the force
; generated energy at a position between two ends is between its values at these and where the wall balances the force
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const lo Real)
(declare-const x Real)
(declare-const hi Real)
(declare-const F Real)
(declare-const e Real)
(declare-const floor1 Real) ; floor of e
(assert (and (<= floor1 e) (< e (+ floor1 1))))
(define-fun def2 () Real (+ (* (- F (- (+ floor1 (/ 1 2)))) (- lo e)) (/ (* (- lo e) (- (+ (- lo e) (+ (- e floor1) (- e floor1))) 1)) 2)))
(define-fun def3 () Real (+ (* (- F (- (+ floor1 (/ 1 2)))) (- hi e)) (/ (* (- hi e) (- (+ (- hi e) (+ (- e floor1) (- e floor1))) 1)) 2)))
(define-fun def4 () Real (ite (<= def2 def3) def2 def3))
(define-fun def5 () Real (- F))
(define-fun def6 () Real (ite (>= def5 lo) def5 lo))
(define-fun def7 () Real (ite (<= def6 hi) def6 hi))
(define-fun def8 () Real (+ (* (- F (- (+ floor1 (/ 1 2)))) (- def7 e)) (/ (* (- def7 e) (- (+ (- def7 e) (+ (- e floor1) (- e floor1))) 1)) 2)))
(define-fun def9 () Real (ite (<= def4 def8) def4 def8))
(define-fun def10 () Real (ite (>= def2 def3) def2 def3))
(define-fun def11 () Real (ite (>= def10 def8) def10 def8))
(assert (<= lo x))
(assert (<= x hi))
; what would contradict the goal
(assert (not (and (<= def9 (+ (* (- F (- (+ floor1 (/ 1 2)))) (- x e)) (/ (* (- x e) (- (+ (- x e) (+ (- e floor1) (- e floor1))) 1)) 2))) (<= (+ (* (- F (- (+ floor1 (/ 1 2)))) (- x e)) (/ (* (- x e) (- (+ (- x e) (+ (- e floor1) (- e floor1))) 1)) 2)) def11))))
(check-sat)
