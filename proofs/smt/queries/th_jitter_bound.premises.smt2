; TH-JITTER, bound: E_d − E_gᴸ is at least the bound in an interval of any length
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const dtau Real)
(assert (> dtau 0))
(check-sat)
