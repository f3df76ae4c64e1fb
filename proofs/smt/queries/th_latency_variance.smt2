; TH-LATENCY, variance: the variance of a latency is f(1 − f), from 0 to ¼
; the variance of a latency is f(1 − f), from 0 to ¼
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const s Real)
(declare-const floor1 Real) ; floor of s
(assert (and (<= floor1 s) (< s (+ floor1 1))))
; what would contradict the goal
(assert (not (and (= (* (- s floor1) (- 1 (- s floor1))) (* (- s floor1) (- 1 (- s floor1)))) (<= 0 (* (- s floor1) (- 1 (- s floor1)))) (<= (* (- s floor1) (- 1 (- s floor1))) (/ (/ 1 2) 2)))))
(check-sat)
