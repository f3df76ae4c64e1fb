; TH-COUNTS, arc straight least: no value on a part of a parabola is beyond those at its ends and where it turns
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const from Real)
(declare-const d Real)
(declare-const to Real)
(declare-const alpha Real)
(assert (<= from d))
(assert (<= d to))
(assert (= alpha 0))
(check-sat)
