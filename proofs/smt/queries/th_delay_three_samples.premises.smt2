; TH-DELAY, three samples: the step pays k·d², what was stored before pays the rest
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
