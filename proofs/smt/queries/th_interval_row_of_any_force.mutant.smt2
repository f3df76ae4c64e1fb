; TH-INTERVAL, row of any force: the account is of the force that was held: its work, and the change of the wall's potential
; not that of the wall on both sides
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const u Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const L Real)
(define-fun def1 () Real (- L))
(define-fun def2 () Real (ite (>= 0 def1) 0 def1))
(define-fun def3 () Real (ite (>= x1 def2) x1 def2))
(define-fun def4 () Real (ite (<= def3 L) def3 L))
(define-fun def5 () Real (ite (>= x0 def2) x0 def2))
(define-fun def6 () Real (ite (<= def5 L) def5 L))
; what would contradict the goal
(assert (not (= (- (+ (* u (- x1 x0)) (- (* x1 def4) (/ (* def4 def4) 2))) (- (* x0 def6) (/ (* def6 def6) 2))) (- (+ (* u (- x1 x0)) (- (* x1 x1) (/ (* x1 x1) 2))) (- (* x0 x0) (/ (* x0 x0) 2))))))
(check-sat)
