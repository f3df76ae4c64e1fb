; TH-UNI, gate: the floor of the gate is −1 outside of the wall and 0 inside
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
