; TH-DAMP, commands damped stepped: the force held is off the law of the wall by at most B|q − q₁| + ½δ
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
(define-fun def1 () Real (+ (/ (* (- (+ (* 1.0 q) (* (- B) (- q1 q)))) 1.0) delta) (/ 1.0 2)))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(assert (<= 0.0 B))
(assert (> delta 0.0))
(assert (> L 0.0))
(assert (= B (/ 1.0 1.0)))
(assert (= delta (/ 1.0 1.0)))
(assert (= L (/ 9.0 1.0)))
(assert (= q (/ 9.0 4.0)))
(assert (= q1 (/ 0.0 1.0)))
; what would contradict the goal
(assert (not (= (+ (/ (* (to_real floor2) delta) 1.0) q) 0.0)))
(check-sat)
