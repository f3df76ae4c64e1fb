; TH-REGION, towards the best period from above: where a period meets the criterion up to a speed, each shorter one does down to the best at the speed, as long as it is enough near rest
; not if it is not enough near rest
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const T Real)
(declare-const b Real)
(declare-const c Real)
(declare-const B Real)
(declare-const T1 Real)
(assert (> 1 0))
(assert (> T 0))
(assert (<= 0 b))
(assert (<= 0 c))
(assert (> 1 0))
(assert (<= 0 B))
(assert (> T1 0))
(assert (<= T1 T))
(assert (<= (/ (+ (- c (/ (* 1 1) 2)) (* (- b B) 1)) (+ (* (* (* 1 1) (+ (/ 1 2) 1)) 1) (* (* (* 1 1) (+ (/ 1 2) 1)) 1))) T1))
(assert (and (<= 0 (- c (+ (/ (* 1 1) 2) (* B (/ 1 T))))) (<= 0 (+ (* (- b (+ (* (* 1 T) (+ (/ 1 2) 1)) B)) 1) (- c (+ (/ (* 1 1) 2) (* B (/ 1 T))))))))
; what would contradict the goal
(assert (not (and (<= 0 (- c (+ (/ (* 1 1) 2) (* B (/ 1 T1))))) (<= 0 (+ (* (- b (+ (* (* 1 T1) (+ (/ 1 2) 1)) B)) 1) (- c (+ (/ (* 1 1) 2) (* B (/ 1 T1)))))))))
(check-sat)
