; TH-ACTIVE, room of a long cycle: in a cycle that the code considers friction leaves room: 2βa < m + 1 − 2βm − 2σ
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const beta Real)
(declare-const sigma Real)
(assert (<= 0 beta))
(assert (<= 0 sigma))
(assert (and (> beta 0) (> (/ 1 2) beta)))
(assert (<= (/ 1 2) sigma))
(check-sat)
