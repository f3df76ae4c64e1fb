; TH-DAMP, commands limited: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; it is not nothing
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(define-fun def1 () Real (- (* 1 q)))
(define-fun def2 () Real (ite (<= def1 L) def1 L))
(define-fun def3 () Real (- L))
(define-fun def4 () Real (ite (>= def2 def3) def2 def3))
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
; what would contradict the goal
(assert (not (= def4 0)))
(check-sat)
