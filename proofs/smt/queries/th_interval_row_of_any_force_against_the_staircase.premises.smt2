; TH-INTERVAL, row of any force against the staircase: against the quantized law it is the work and the change of the staircase's potential
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const L Real)
(assert (> L 0))
(check-sat)
