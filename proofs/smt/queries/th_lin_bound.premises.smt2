; TH-LIN, bound: E_gᴸ is at most ½d² + ½|d|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
