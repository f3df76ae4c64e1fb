; TH-DAMP, commands damped: the force held is off the law of the wall by at most B|q − q₁| + ½δ
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
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
(assert (= B (/ 1 1)))
(assert (= delta (/ 1 1)))
(assert (= L (/ 9 1)))
(assert (= q (/ 9 4)))
(assert (= q1 (/ 0 1)))
; what would contradict the goal
(assert (not (= (+ (- (+ (* 1 q) (* (- B) (- q1 q)))) q) 0)))
(check-sat)
