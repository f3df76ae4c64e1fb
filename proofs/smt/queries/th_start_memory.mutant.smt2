; TH-START, memory: ½μV² is the storage at the start, with what the controller remembers
; without what it remembers it is not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const mu Real)
(declare-const v0 Real)
(declare-const x0 Real)
(declare-const extra Real)
(assert (> mu 0))
; what would contradict the goal
(assert (not (= (/ (* mu (+ (* v0 v0) (/ (* x0 x0) mu))) 2) (+ (+ (/ (* mu (* v0 v0)) 2) (/ (* x0 x0) 2)) extra))))
(check-sat)
