; TH-SMOOTH, step: without an encoder a step generates ½d², which is all that it costs
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
