; TH-COUNTS, extremes back down: no value of the parabola with a kink, on one side of it, is beyond the extremes that the code finds
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const from Real)
(declare-const to Real)
(declare-const alpha Real)
(declare-const d Real)
(assert (> 0 from))
(assert (<= to 0))
(assert (<= from to))
(assert (> 0 alpha))
(assert (<= from d))
(assert (<= d to))
(check-sat)
