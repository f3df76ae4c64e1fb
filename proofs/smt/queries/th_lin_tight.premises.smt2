; TH-LIN, tight: downwards from a tick the bound is reached; upwards it is missed by (1 − ρ₀)d
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(assert (or (> 0 (- x1 x0)) (> (- x1 x0) 0)))
(check-sat)
