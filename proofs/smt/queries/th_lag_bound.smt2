; TH-LAG, bound: the bound of the variance that needs no exponential is that of the latency and min(θ/2, 1/12)
; the bound of the variance that needs no exponential is that of the latency and min(θ/2, 1/12)
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const theta Real)
(declare-const s Real)
(declare-const floor1 Real) ; floor of s
(assert (and (<= floor1 s) (< s (+ floor1 1))))
(define-fun def2 () Real (/ theta 2))
(define-fun def3 () Real (/ 1 12))
(define-fun def4 () Real (ite (<= def2 def3) def2 def3))
(assert (<= 0 theta))
; what would contradict the goal
(assert (not (or (and (= (+ (* (- s floor1) (- 1 (- s floor1))) def4) (+ (* (- s floor1) (- 1 (- s floor1))) def2)) (<= theta (/ 1 6))) (and (= (+ (* (- s floor1) (- 1 (- s floor1))) def4) (+ (* (- s floor1) (- 1 (- s floor1))) def3)) (<= (/ 1 6) theta)))))
(check-sat)
