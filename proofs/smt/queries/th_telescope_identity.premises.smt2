; TH-TELESCOPE, identity: E_g − E_gᴸ is the change of ½ρ(1 − ρ)
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
