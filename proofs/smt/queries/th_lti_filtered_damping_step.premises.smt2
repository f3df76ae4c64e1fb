; TH-LTI, filtered damping step: friction less what the command draws and the filter stores is B times what the step before has to spare, and what friction has beyond the cost: not below zero where β is the cost or more
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const a Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
(check-sat)
