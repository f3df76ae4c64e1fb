; TH-REGION, box of shortest period with damping up to a speed: where the period pulls both ways, holds is said of all periods, fails of none, and it depends where some meet the criterion
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const T0 Real)
(assert (> T0 0))
(assert (<= T0 2))
(check-sat)
