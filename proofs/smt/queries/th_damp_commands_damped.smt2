; TH-DAMP, commands damped: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; the force held is off the law of the wall by at most B|q − q₁| + ½δ
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(declare-const q1 Real)
(define-fun def1 () Real (+ (- (+ (* 1 q) (* (- B) (- q1 q)))) q))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(define-fun def3 () Real (- q q1))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
; what would contradict the goal
(assert (not (<= def2 (+ (* B def4) 0))))
(check-sat)
