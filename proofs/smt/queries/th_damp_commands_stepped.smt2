; TH-DAMP, commands stepped: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; the force held is off the law of the wall by at most B|q − q₁| + ½δ
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(define-fun def1 () Real (+ (/ (* (- (* 1 q)) 1) delta) (/ 1 2)))
(declare-const floor2 Real) ; floor of def1
(assert (and (<= floor2 def1) (< def1 (+ floor2 1))))
(define-fun def3 () Real (+ (/ (* floor2 delta) 1) q))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
; what would contradict the goal
(assert (not (<= def4 (+ 0 (/ delta 2)))))
(check-sat)
