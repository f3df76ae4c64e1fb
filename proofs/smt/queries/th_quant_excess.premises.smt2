; TH-QUANT, excess: the tight bound exceeds (22) by at most 1/8
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
