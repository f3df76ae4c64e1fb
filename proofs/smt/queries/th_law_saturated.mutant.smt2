; TH-LAW, saturated: a limit of the force clips it
; it does not leave it
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const limit Real)
(declare-const x Real)
(define-fun def1 () Real (- limit))
(define-fun def2 () Real (ite (>= x def1) x def1))
(define-fun def3 () Real (ite (<= def2 limit) def2 limit))
(assert (<= 0 limit))
; what would contradict the goal
(assert (not (= def3 x)))
(check-sat)
