; TH-DAMP, commands one sided damped stepped: the force held is off the law of the wall by at most B|q − q₁| + ½δ
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
(define-fun def1 () Real (- 1))
(define-fun def2 () Real (ite (>= q def1) q def1))
(define-fun def3 () Real (ite (<= def2 0) def2 0))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(define-fun def5 () Real (+ (/ (* (- (* (+ (* 1 q) (* (- B) (- q1 q))) (+ floor4 1))) 1) delta) (/ 1 2)))
(declare-const floor6 Real) ; floor of def5
(assert (and (<= floor6 def5) (< def5 (+ floor6 1))))
(define-fun def7 () Real (ite (>= q 0) q 0))
(define-fun def8 () Real (+ (/ (* floor6 delta) 1) def7))
(define-fun def9 () Real (ite (>= def8 0) def8 (- def8)))
(define-fun def10 () Real (- q q1))
(define-fun def11 () Real (ite (>= def10 0) def10 (- def10)))
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
(assert (or (= floor4 def1) (= floor4 0)))
; what would contradict the goal
(assert (not (<= def9 (+ (* B def11) (/ delta 2)))))
(check-sat)
