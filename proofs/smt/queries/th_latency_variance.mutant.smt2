; TH-LATENCY, variance: the variance of a latency is f(1 − f), from 0 to ¼
; it can be above 1/5
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const s Real)
(declare-const floor1 Int) ; floor of s
(assert (and (<= (to_real floor1) s) (< s (+ (to_real floor1) 1))))
; what would contradict the goal
(assert (not (<= (* (- s (to_real floor1)) (- 1.0 (- s (to_real floor1)))) (/ 1.0 5.0))))
(check-sat)
