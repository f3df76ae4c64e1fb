; TH-COUNTS, start position: generated energy at a position between two ends is between its values at these and where the wall balances the force
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
(declare-const floor1 Real) ; floor of lo
(assert (and (<= floor1 lo) (< lo (+ floor1 1))))
(define-fun def2 () Real (+ (* (- F (- (+ floor1 (/ 1 2)))) (- e lo)) (/ (* (- e lo) (- (+ (- e lo) (+ (- lo floor1) (- lo floor1))) 1)) 2)))
(declare-const floor3 Real) ; floor of hi
(assert (and (<= floor3 hi) (< hi (+ floor3 1))))
(define-fun def4 () Real (+ (* (- F (- (+ floor3 (/ 1 2)))) (- e hi)) (/ (* (- e hi) (- (+ (- e hi) (+ (- hi floor3) (- hi floor3))) 1)) 2)))
(define-fun def5 () Real (ite (<= def2 def4) def2 def4))
(define-fun def6 () Real (- F))
(define-fun def7 () Real (ite (>= def6 lo) def6 lo))
(define-fun def8 () Real (ite (<= def7 hi) def7 hi))
(declare-const floor9 Real) ; floor of def8
(assert (and (<= floor9 def8) (< def8 (+ floor9 1))))
(define-fun def10 () Real (+ (* (- F (- (+ floor9 (/ 1 2)))) (- e def8)) (/ (* (- e def8) (- (+ (- e def8) (+ (- def8 floor9) (- def8 floor9))) 1)) 2)))
(define-fun def11 () Real (ite (<= def5 def10) def5 def10))
(declare-const floor12 Real) ; floor of x
(assert (and (<= floor12 x) (< x (+ floor12 1))))
(define-fun def13 () Real (ite (>= def2 def4) def2 def4))
(define-fun def14 () Real (ite (>= def13 def10) def13 def10))
(assert (<= lo x))
(assert (<= x hi))
; what would contradict the goal
(assert (not (and (<= def11 (+ (* (- F (- (+ floor12 (/ 1 2)))) (- e x)) (/ (* (- e x) (- (+ (- e x) (+ (- x floor12) (- x floor12))) 1)) 2))) (<= (+ (* (- F (- (+ floor12 (/ 1 2)))) (- e x)) (/ (* (- e x) (- (+ (- e x) (+ (- x floor12) (- x floor12))) 1)) 2)) def14))))
(check-sat)
