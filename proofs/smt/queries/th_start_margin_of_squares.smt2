; TH-START, margin of squares: for viscous < 0 < coulomb the margin of squares has the sign of the margin at V
; for viscous < 0 < coulomb the margin of squares has the sign of the margin at V
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const bound Real)
(declare-const viscous Real)
(declare-const coulomb Real)
(assert (> bound 0))
(assert (> 0 viscous))
(assert (> coulomb 0))
; what would contradict the goal
(assert (not (and (or (not (<= 0 (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound))))) (<= 0 (+ (* viscous bound) coulomb))) (or (not (<= 0 (+ (* viscous bound) coulomb))) (<= 0 (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound))))))))
(check-sat)
