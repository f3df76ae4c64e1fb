; TH-COUNTS, arc turn: where it turns is between the ends
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const from Real)
(declare-const to Real)
(assert (<= from to))
(check-sat)
