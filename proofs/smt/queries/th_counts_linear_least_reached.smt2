; TH-COUNTS, linear least reached: the code's end is generated where both places are at an end or where the wall balances the force
; the code's end is generated where both places are at an end or where the wall balances the force
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x Real)
(declare-const y Real)
(declare-const f Real)
(declare-const k Real)
(define-fun def1 () Real (- (/ 1 2) (+ f k)))
(define-fun def2 () Real (ite (>= def1 0) def1 0))
(define-fun def3 () Real (ite (<= def2 1) def2 1))
(define-fun def4 () Real (- (/ 1 2) f))
(define-fun def5 () Real (ite (>= def4 k) def4 k))
(define-fun def6 () Real (+ k 1))
(define-fun def7 () Real (ite (<= def5 def6) def5 def6))
(define-fun def8 () Real (ite (>= f 0) f 0))
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (and (or (and (<= 0 f) (= x 1)) (and (> 0 f) (= x 0))) (= y def3)))
; what would contradict the goal
(assert (not (= (- (* def7 (+ f (/ (- def7 1) 2))) def8) (- (* (+ k y) (+ f (/ (- (+ k y) 1) 2))) (* x (+ f (/ (- x 1) 2)))))))
(check-sat)
