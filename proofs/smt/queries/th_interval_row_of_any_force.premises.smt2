; TH-INTERVAL, row of any force: the account is of the force that was held: its work, and the change of the wall's potential
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
