; TH-COUNTS, curvature: the code finds a parabola from its values at two places and half way between them
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const to Real)
(declare-const from Real)
(assert (or (> to from) (> from to)))
(check-sat)
