; TH-COUNTS, counted linear most: wherever within their ticks the positions are, generated energy is not beyond the end that the code finds
; it is not always there
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x Real)
(declare-const y Real)
(declare-const k Real)
(declare-const f Real)
(define-fun def1 () Real (+ f k))
(define-fun def2 () Real (ite (>= def1 0) def1 0))
(define-fun def3 () Real (- (/ 1 2) f))
(define-fun def4 () Real (ite (>= def3 0) def3 0))
(define-fun def5 () Real (ite (<= def4 1) def4 1))
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (= k (/ 1 1)))
(assert (= f (/ 0 1)))
(assert (= x (/ 1 2)))
(assert (= y (/ 1 2)))
; what would contradict the goal
(assert (not (= (- (+ (* k (+ f (/ (- k 1) 2))) def2) (* def5 (+ f (/ (- def5 1) 2)))) (- (* (+ k y) (+ f (/ (- (+ k y) 1) 2))) (* x (+ f (/ (- x 1) 2)))))))
(check-sat)
