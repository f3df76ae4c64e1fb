; TH-LAG, decision: more variance is never decided for less friction: an enclosure's upper end is safe
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const m Real)
(declare-const Var Real)
(declare-const more Real)
(assert (<= 0 m))
(assert (<= 0 Var))
(assert (<= Var more))
(check-sat)
