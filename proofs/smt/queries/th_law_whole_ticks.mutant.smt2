; TH-LAW, whole ticks: a tick, which is whole, is not below another or at least one below it; the first beyond a limit is not below zero
; not always below
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const upper Real)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(assert (<= 0.0 upper))
; what would contradict the goal
(assert (not (<= (+ (to_real floor1) 1.0) 0.0)))
(check-sat)
