; TH-LAW, whole ticks: a tick, which is whole, is not below another or at least one below it; the first beyond a limit is not below zero
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const upper Real)
(assert (<= 0 upper))
(check-sat)
