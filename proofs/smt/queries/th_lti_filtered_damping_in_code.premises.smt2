; TH-LTI, filtered damping in code: the code's command is the position and B times the filter's state
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
