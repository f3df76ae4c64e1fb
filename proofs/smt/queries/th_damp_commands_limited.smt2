; TH-DAMP, commands limited: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; the force held is off the law of the wall by at most B|q − q₁| + ½δ
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(define-fun def1 () Real (- (* 1 q)))
(define-fun def2 () Real (ite (<= def1 L) def1 L))
(define-fun def3 () Real (- L))
(define-fun def4 () Real (ite (>= def2 def3) def2 def3))
(define-fun def5 () Real (ite (>= q def3) q def3))
(define-fun def6 () Real (ite (<= def5 L) def5 L))
(define-fun def7 () Real (+ def4 def6))
(define-fun def8 () Real (ite (>= def7 0) def7 (- def7)))
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
; what would contradict the goal
(assert (not (<= def8 (+ 0 0))))
(check-sat)
