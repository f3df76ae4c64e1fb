; TH-LTI, filtered damping cost: the code charges ½ and B(1 − a)/(1 + a) of viscous friction
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const a Real)
(declare-const share Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
(assert (= (* share (+ 1 a)) (- 1 a)))
(check-sat)
