; TH-COUNTS, corners: net energy at the corners of the two ticks is what the code has there
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
