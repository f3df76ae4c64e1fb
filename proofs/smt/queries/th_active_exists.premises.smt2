; TH-ACTIVE, exists: where β < ½ or σ < ½ the code comes to consider a cycle
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const beta Real)
(declare-const sigma Real)
(assert (<= 0 beta))
(assert (<= 0 sigma))
(assert (or (> (/ 1 2) beta) (> (/ 1 2) sigma)))
(check-sat)
