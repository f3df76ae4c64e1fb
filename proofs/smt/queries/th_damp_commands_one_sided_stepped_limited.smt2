; TH-DAMP, commands one sided stepped limited: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; the force held is off the law of the wall by at most B|q − q₁| + ½δ
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(define-fun def1 () Real (- 1))
(define-fun def2 () Real (ite (>= q def1) q def1))
(define-fun def3 () Real (ite (<= def2 0) def2 0))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(define-fun def5 () Real (+ (/ (* (- (* (* 1 q) (+ floor4 1))) 1) delta) (/ 1 2)))
(declare-const floor6 Real) ; floor of def5
(assert (and (<= floor6 def5) (< def5 (+ floor6 1))))
(define-fun def7 () Real (/ (* floor6 delta) 1))
(define-fun def8 () Real (ite (<= def7 L) def7 L))
(define-fun def9 () Real (- L))
(define-fun def10 () Real (ite (>= def8 def9) def8 def9))
(define-fun def11 () Real (ite (>= 0 def9) 0 def9))
(define-fun def12 () Real (ite (>= q def11) q def11))
(define-fun def13 () Real (ite (<= def12 L) def12 L))
(define-fun def14 () Real (+ def10 def13))
(define-fun def15 () Real (ite (>= def14 0) def14 (- def14)))
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
(assert (or (= floor4 def1) (= floor4 0)))
; what would contradict the goal
(assert (not (<= def15 (+ 0 (/ delta 2)))))
(check-sat)
