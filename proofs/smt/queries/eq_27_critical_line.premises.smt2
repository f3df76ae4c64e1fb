; EQ-27, critical line: on the line (9) the margin is zero
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
