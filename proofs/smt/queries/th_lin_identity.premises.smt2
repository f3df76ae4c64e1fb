; TH-LIN, identity: the formula is the definition (18) against the linear spring
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
