; TH-START, energy: while storage stays below that at the start, the speed stays below V
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const mu Real)
(declare-const v1 Real)
(declare-const x1 Real)
(declare-const v0 Real)
(declare-const x0 Real)
(assert (> mu 0))
(assert (<= (+ (/ (* mu (* v1 v1)) 2) (/ (* x1 x1) 2)) (+ (/ (* mu (* v0 v0)) 2) (/ (* x0 x0) 2))))
(check-sat)
