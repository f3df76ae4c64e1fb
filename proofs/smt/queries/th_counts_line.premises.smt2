; TH-COUNTS, line: on a line of equal displacement net energy is between its values at any two points around
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const dtau Real)
(declare-const back Real)
(declare-const ahead Real)
(assert (> dtau 0))
(assert (<= back 0))
(assert (<= 0 ahead))
(check-sat)
