; TH-COUNTS, quantized most reached: the code's end is generated where both places are at an end or where the wall balances the force
; elsewhere it is not
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
(define-fun def3 () Real (ite (<= f 0) f 0))
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (= k (/ 1 1)))
(assert (= f (/ 0 1)))
(assert (= x (/ 1 2)))
(assert (= y (/ 1 2)))
; what would contradict the goal
(assert (not (= (- (+ (* k (+ f (/ (- k 1) 2))) def2) def3) (- (+ (* k (+ f (/ (- k 1) 2))) (* def1 y)) (* f x)))))
(check-sat)
