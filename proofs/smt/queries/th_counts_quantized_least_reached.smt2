; TH-COUNTS, quantized least reached: the code's end is generated where both places are at an end or where the wall balances the force
; the code's end is generated where both places are at an end or where the wall balances the force
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x Real)
(declare-const y Real)
(declare-const f Real)
(declare-const k Real)
(define-fun def1 () Real (+ f k))
(define-fun def2 () Real (ite (<= def1 0) def1 0))
(define-fun def3 () Real (ite (>= f 0) f 0))
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (and (or (and (<= 0 f) (= x 1)) (and (> 0 f) (= x 0))) (or (and (> 0 (+ f k)) (= y 1)) (and (<= 0 (+ f k)) (= y 0)))))
; what would contradict the goal
(assert (not (= (- (+ (* k (+ f (/ (- k 1) 2))) def2) def3) (- (+ (* k (+ f (/ (- k 1) 2))) (* def1 y)) (* f x)))))
(check-sat)
