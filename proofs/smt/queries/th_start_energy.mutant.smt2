; TH-START, energy: while storage stays below that at the start, the speed stays below V
; not when storage grows
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const mu Real)
(declare-const v1 Real)
(declare-const v0 Real)
(declare-const x0 Real)
(assert (> mu 0))
; what would contradict the goal
(assert (not (<= (* v1 v1) (+ (* v0 v0) (/ (* x0 x0) mu)))))
(check-sat)
