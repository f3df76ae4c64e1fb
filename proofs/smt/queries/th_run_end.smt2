; TH-RUN, end: storage is not negative, so what was drawn stays below the storage at the start
; storage is not negative, so what was drawn stays below the storage at the start
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const mu Real)
(declare-const drawn Real)
(declare-const v Real)
(declare-const x Real)
(declare-const first Real)
(assert (> mu 0))
(assert (<= (+ drawn (+ (/ (* mu (* v v)) 2) (/ (* x x) 2))) first))
; what would contradict the goal
(assert (not (<= drawn first)))
(check-sat)
