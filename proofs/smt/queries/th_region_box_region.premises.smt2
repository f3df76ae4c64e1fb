; TH-REGION, box region: the region of a box is that of every loop in it
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const v Real)
(declare-const beta0 Real)
(declare-const beta Real)
(declare-const beta1 Real)
(declare-const sigma0 Real)
(declare-const sigma Real)
(declare-const sigma1 Real)
(assert (> v 0))
(assert (<= beta0 beta))
(assert (<= beta beta1))
(assert (<= sigma0 sigma))
(assert (<= sigma sigma1))
(check-sat)
