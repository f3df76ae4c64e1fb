; EQ-23..26, merging sum: what both dissipate is the sum
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const t1 Real)
(assert (> t1 0))
(check-sat)
