; TH-DAMP, commands one sided stepped: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; it is not the law itself
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(declare-const q1 Real)
(define-fun def1 () Real (- 1.0))
(define-fun def2 () Real (ite (>= q def1) q def1))
(define-fun def3 () Real (ite (<= def2 0.0) def2 0.0))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (+ (/ (* (- (* (* 1.0 q) (+ (to_real floor4) 1.0))) 1.0) delta) (/ 1.0 2)))
(declare-const floor6 Int) ; floor of def5
(assert (and (<= (to_real floor6) def5) (< def5 (+ (to_real floor6) 1))))
(define-fun def7 () Real (ite (>= q 0.0) q 0.0))
(assert (<= 0.0 B))
(assert (> delta 0.0))
(assert (> L 0.0))
(assert (or (= (to_real floor4) def1) (= (to_real floor4) 0.0)))
(assert (= B (/ 1.0 1.0)))
(assert (= delta (/ 1.0 1.0)))
(assert (= L (/ 9.0 1.0)))
(assert (= q (/ 9.0 4.0)))
(assert (= q1 (/ 0.0 1.0)))
; what would contradict the goal
(assert (not (= (+ (/ (* (to_real floor6) delta) 1.0) def7) 0.0)))
(check-sat)
