; TH-DAMP, encoder: the ticks between two samples differ from the way by less than one
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
