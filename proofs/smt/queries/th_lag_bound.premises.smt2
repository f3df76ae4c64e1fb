; TH-LAG, bound: the bound of the variance that needs no exponential is that of the latency and min(θ/2, 1/12)
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const theta Real)
(assert (<= 0 theta))
(check-sat)
