; TH-REGION, speeds: a region is the set of speeds at which the criterion holds
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const v Real)
(assert (> v 0))
(check-sat)
