; TH-DAC, order: rounded first and limited then: the limit need not be a whole step
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const delta Real)
(declare-const L Real)
(assert (> delta 0))
(assert (> L 0))
(check-sat)
