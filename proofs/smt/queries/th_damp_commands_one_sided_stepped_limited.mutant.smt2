; TH-DAMP, commands one sided stepped limited: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; it is not the law itself
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(define-fun def1 () Real (- 1.0))
(define-fun def2 () Real (ite (>= q def1) q def1))
(define-fun def3 () Real (ite (<= def2 0.0) def2 0.0))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (+ (/ (* (- (* (* 1.0 q) (+ (to_real floor4) 1.0))) 1.0) delta) (/ 1.0 2)))
(declare-const floor6 Int) ; floor of def5
(assert (and (<= (to_real floor6) def5) (< def5 (+ (to_real floor6) 1))))
(define-fun def7 () Real (/ (* (to_real floor6) delta) 1.0))
(define-fun def8 () Real (ite (<= def7 L) def7 L))
(define-fun def9 () Real (- L))
(define-fun def10 () Real (ite (>= def8 def9) def8 def9))
(define-fun def11 () Real (ite (>= 0.0 def9) 0.0 def9))
(define-fun def12 () Real (ite (>= q def11) q def11))
(define-fun def13 () Real (ite (<= def12 L) def12 L))
(assert (<= 0.0 B))
(assert (> delta 0.0))
(assert (> L 0.0))
(assert (or (= (to_real floor4) def1) (= (to_real floor4) 0.0)))
; what would contradict the goal
(assert (not (= (+ def10 def13) 0.0)))
(check-sat)
