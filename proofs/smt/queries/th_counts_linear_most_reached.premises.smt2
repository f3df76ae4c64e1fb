; TH-COUNTS, linear most reached: the code's end is generated where both places are at an end or where the wall balances the force
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x Real)
(declare-const y Real)
(declare-const f Real)
(declare-const k Real)
(define-fun def1 () Real (- (/ 1 2) f))
(define-fun def2 () Real (ite (>= def1 0) def1 0))
(define-fun def3 () Real (ite (<= def2 1) def2 1))
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (and (or (and (<= 0 (+ f k)) (= y 1)) (and (> 0 (+ f k)) (= y 0))) (= x def3)))
(check-sat)
