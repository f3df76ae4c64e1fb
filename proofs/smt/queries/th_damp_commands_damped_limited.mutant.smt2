; TH-DAMP, commands damped limited: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; it is not the law itself
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(declare-const q1 Real)
(define-fun def1 () Real (- (+ (* 1 q) (* (- B) (- q1 q)))))
(define-fun def2 () Real (ite (<= def1 L) def1 L))
(define-fun def3 () Real (- L))
(define-fun def4 () Real (ite (>= def2 def3) def2 def3))
(define-fun def5 () Real (ite (>= q def3) q def3))
(define-fun def6 () Real (ite (<= def5 L) def5 L))
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
; what would contradict the goal
(assert (not (= (+ def4 def6) 0)))
(check-sat)
