; TH-COUNTS, reached back: both extremes are values at an end, or κ − (γ ± σ)²/4α where the slope changes its sign
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const from Real)
(declare-const to Real)
(assert (> 0 from))
(assert (<= to 0))
(assert (<= from to))
(check-sat)
