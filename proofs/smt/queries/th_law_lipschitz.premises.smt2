; TH-LAW, lipschitz: the law is nowhere stiffer than the wall
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const lower Real)
(declare-const upper Real)
(assert (<= lower 0))
(assert (<= 0 upper))
(check-sat)
