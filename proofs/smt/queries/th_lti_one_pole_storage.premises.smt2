; TH-LTI, one pole storage: what the storage w²/(2(1 − a)) of the filter gains over a sample is a polynomial
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const a Real)
(declare-const stored Real)
(declare-const w Real)
(declare-const x1 Real)
(declare-const x0 Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
(assert (= (* stored (+ (- 1 a) (- 1 a))) (- (* (+ (* a w) (* (- 1 a) (- x1 x0))) (+ (* a w) (* (- 1 a) (- x1 x0)))) (* w w))))
(check-sat)
