; TH-COUNTS, quantized least reached: the code's end is generated where both places are at an end or where the wall balances the force
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x Real)
(declare-const y Real)
(declare-const f Real)
(declare-const k Real)
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (and (or (and (<= 0 f) (= x 1)) (and (> 0 f) (= x 0))) (or (and (> 0 (+ f k)) (= y 1)) (and (<= 0 (+ f k)) (= y 0)))))
(check-sat)
