; TH-JITTER, bound of 22: the bound is what friction dissipates less ½d² + ½|d|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const dtau Real)
(assert (> dtau 0))
(check-sat)
