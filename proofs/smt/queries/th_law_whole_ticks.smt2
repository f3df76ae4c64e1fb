; TH-LAW, whole ticks: a tick, which is whole, is not below another or at least one below it; the first beyond a limit is not below zero
; a tick, which is whole, is not below another or at least one below it; the first beyond a limit is not below zero
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status unsat)
(declare-const upper Real)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(define-fun def2 () Real (- (/ 1.0 2) upper))
(declare-const floor3 Int) ; floor of def2
(assert (and (<= (to_real floor3) def2) (< def2 (+ (to_real floor3) 1))))
(assert (<= 0.0 upper))
; what would contradict the goal
(assert (not (and (or (<= 0.0 (to_real floor1)) (<= (+ (to_real floor1) 1.0) 0.0)) (<= 0.0 (- (to_real floor3))))))
(check-sat)
