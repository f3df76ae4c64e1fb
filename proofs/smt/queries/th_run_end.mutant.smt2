; TH-RUN, end: storage is not negative, so what was drawn stays below the storage at the start
; not when it is not accounted for
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const mu Real)
(declare-const drawn Real)
(declare-const first Real)
(assert (> mu 0))
; what would contradict the goal
(assert (not (<= drawn first)))
(check-sat)
