; TH-REGION, direction of speed bound: wherever it is in its tolerance, the criterion is no easier than at the easiest end and no harder than at the hardest
; wherever it is in its tolerance, the criterion is no easier than at the easiest end and no harder than at the hardest
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const V0 Real)
(declare-const V Real)
(declare-const V1 Real)
(declare-const coulomb Real)
(declare-const viscous Real)
(define-fun def1 () Real (+ (* viscous V1) coulomb))
(define-fun def2 () Real (ite (<= coulomb def1) coulomb def1))
(define-fun def3 () Real (+ (* viscous V) coulomb))
(define-fun def4 () Real (ite (<= coulomb def3) coulomb def3))
(define-fun def5 () Real (+ (* viscous V0) coulomb))
(define-fun def6 () Real (ite (<= coulomb def5) coulomb def5))
(assert (> V0 0))
(assert (<= V0 V))
(assert (<= V V1))
; what would contradict the goal
(assert (not (and (<= def2 def4) (<= def4 def6))))
(check-sat)
