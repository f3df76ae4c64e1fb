; TH-TELESCOPE, bound: from any start to any end the change of ½ρ(1 − ρ) is within 1/8
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
