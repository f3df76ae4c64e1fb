; EQ-19/20, forms: (19) with (20), ½D² + D(ρ₁ − ½) and the integral (18) are one
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
