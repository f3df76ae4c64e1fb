; TH-LAW, saturated: a limit of the force clips it
; a limit of the force clips it
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const limit Real)
(declare-const x Real)
(define-fun def1 () Real (- limit))
(define-fun def2 () Real (ite (>= x def1) x def1))
(define-fun def3 () Real (ite (<= def2 limit) def2 limit))
(define-fun def4 () Real (ite (<= x limit) x limit))
(define-fun def5 () Real (ite (>= def4 def1) def4 def1))
(assert (<= 0 limit))
; what would contradict the goal
(assert (not (= def3 def5)))
(check-sat)
