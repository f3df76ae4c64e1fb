; TH-SMOOTH, witness: without an encoder a cycle is found exactly where β < ½, and gains 2(½d² − βd² − σd)
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const beta Real)
(declare-const sigma Real)
(assert (<= 0 beta))
(assert (<= 0 sigma))
(check-sat)
