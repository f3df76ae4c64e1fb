; TH-START, margin of squares: for viscous < 0 < coulomb the margin of squares has the sign of the margin at V
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const bound Real)
(declare-const viscous Real)
(declare-const coulomb Real)
(assert (> bound 0))
(assert (> 0 viscous))
(assert (> coulomb 0))
(check-sat)
