; TH-LAW, saturated: a limit of the force clips it
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const limit Real)
(assert (<= 0 limit))
(check-sat)
