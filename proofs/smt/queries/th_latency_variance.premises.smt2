; TH-LATENCY, variance: the variance of a latency is f(1 − f), from 0 to ¼
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
