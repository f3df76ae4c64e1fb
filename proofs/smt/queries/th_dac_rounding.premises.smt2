; TH-DAC, rounding: rounding to steps of δ is off by at most ½δ
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const delta Real)
(assert (> delta 0))
(check-sat)
