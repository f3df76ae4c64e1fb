; TH-LAG, bound: the bound of the variance that needs no exponential is that of the latency and min(θ/2, 1/12)
; it is not always θ/2
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const theta Real)
(declare-const s Real)
(declare-const floor1 Int) ; floor of s
(assert (and (<= (to_real floor1) s) (< s (+ (to_real floor1) 1))))
(define-fun def2 () Real (/ theta 2))
(define-fun def3 () Real (/ 1.0 12.0))
(define-fun def4 () Real (ite (<= def2 def3) def2 def3))
(assert (<= 0.0 theta))
; what would contradict the goal
(assert (not (= (+ (* (- s (to_real floor1)) (- 1.0 (- s (to_real floor1)))) def4) (+ (* (- s (to_real floor1)) (- 1.0 (- s (to_real floor1)))) def2))))
(check-sat)
