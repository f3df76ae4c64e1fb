; EQ-23..26, merging viscous: viscous friction dissipates at least as much in two pieces as in the whole (25)
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const beta Real)
(declare-const t1 Real)
(declare-const t2 Real)
(assert (<= 0 beta))
(assert (> t1 0))
(assert (> t2 0))
(check-sat)
