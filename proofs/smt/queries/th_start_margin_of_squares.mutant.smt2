; TH-START, margin of squares: for viscous < 0 < coulomb the margin of squares has the sign of the margin at V
; not for a negative coulomb
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const bound Real)
(declare-const viscous Real)
(declare-const coulomb Real)
(assert (> bound 0))
(assert (> 0 viscous))
; what would contradict the goal
(assert (not (and (or (not (<= 0 (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound))))) (<= 0 (+ (* viscous bound) coulomb))) (or (not (<= 0 (+ (* viscous bound) coulomb))) (<= 0 (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound))))))))
(check-sat)
