; TH-SMOOTH, colgate: without Coulomb friction the criterion is b ≥ KT/2
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const v Real)
(assert (> K 0))
(assert (> T 0))
(assert (> v 0))
(check-sat)
