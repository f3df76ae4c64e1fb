; TH-JITTER, formula: the bound is (β/Δτ − ½)d² + (σ − ½)|d|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const dtau Real)
(assert (> dtau 0))
(check-sat)
