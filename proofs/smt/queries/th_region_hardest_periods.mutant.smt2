; TH-REGION, hardest periods: at a speed and near rest, no period between two is harder than both of them
; the longest alone is not the hardest
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const T Real)
(declare-const b Real)
(declare-const c Real)
(declare-const B Real)
(declare-const T0 Real)
(declare-const T1 Real)
(assert (> 1 0))
(assert (> T 0))
(assert (<= 0 b))
(assert (<= 0 c))
(assert (> 1 0))
(assert (<= 0 B))
(assert (> T0 0))
(assert (<= T0 T))
(assert (<= T T1))
; what would contradict the goal
(assert (not (<= (+ (* (- b (+ (* (* 1 T1) (+ (/ 1 2) 1)) B)) 1) (- c (+ (/ (* 1 1) 2) (* B (/ 1 T1))))) (+ (* (- b (+ (* (* 1 T) (+ (/ 1 2) 1)) B)) 1) (- c (+ (/ (* 1 1) 2) (* B (/ 1 T))))))))
(check-sat)
