; TH-REGION, towards the best period from below: where a period meets the criterion up to a speed, each longer one does up to the best at the speed
; nor does one need to have met it
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
(assert (<= T T1))
(assert (<= T1 (/ (+ (- c (/ (* 1 1) 2)) (* (- b B) 1)) (+ (* (* (* 1 1) (+ (/ 1 2) 1)) 1) (* (* (* 1 1) (+ (/ 1 2) 1)) 1)))))
(assert (and (<= 0 (- c (+ (/ (* 1 1) 2) (* B (/ 1 T))))) (<= 0 (+ (* (- b (+ (* (* 1 T) (+ (/ 1 2) 1)) B)) 1) (- c (+ (/ (* 1 1) 2) (* B (/ 1 T))))))))
; what would contradict the goal
(assert (not (not (and (<= 0 (- c (+ (/ (* 1 1) 2) (* B (/ 1 T))))) (<= 0 (+ (* (- b (+ (* (* 1 T) (+ (/ 1 2) 1)) B)) 1) (- c (+ (/ (* 1 1) 2) (* B (/ 1 T))))))))))
(check-sat)
