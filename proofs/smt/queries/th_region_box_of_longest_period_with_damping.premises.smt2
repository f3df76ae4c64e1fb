; TH-REGION, box of longest period with damping: where the period pulls both ways, holds is said of all periods, fails of none, and it depends where some meet the criterion
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const T1 Real)
(assert (> (/ 1 4) 0))
(assert (<= (/ 1 4) T1))
(check-sat)
