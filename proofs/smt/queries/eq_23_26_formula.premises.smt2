; EQ-23..26, formula: the least that a step dissipates is βd²/Δτ + σ|d|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const t1 Real)
(assert (> t1 0))
(check-sat)
