; TH-START, storage of v: ½μV² is the storage at the start
; ½μV² is the storage at the start
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const mu Real)
(declare-const v0 Real)
(declare-const x0 Real)
(assert (> mu 0))
; what would contradict the goal
(assert (not (= (/ (* mu (+ (* v0 v0) (/ (* x0 x0) mu))) 2) (+ (/ (* mu (* v0 v0)) 2) (/ (* x0 x0) 2)))))
(check-sat)
