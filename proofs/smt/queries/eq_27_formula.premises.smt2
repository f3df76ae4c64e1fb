; EQ-27, formula: the surplus is (β − ½)d²/Δτ + (σ − ½)|d|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const t1 Real)
(assert (> t1 0))
(check-sat)
