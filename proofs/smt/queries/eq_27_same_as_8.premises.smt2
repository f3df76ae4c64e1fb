; EQ-27, same as 8: (27) holds of a move exactly where (8) holds at its mean speed
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const t1 Real)
(declare-const d1 Real)
(assert (> t1 0))
(assert (or (> 0 d1) (> d1 0)))
(check-sat)
