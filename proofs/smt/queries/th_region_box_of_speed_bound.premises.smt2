; TH-REGION, box of speed bound: holds is said for every bound in the tolerance, fails for none, and it depends only where the ends differ
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const V0 Real)
(declare-const V Real)
(declare-const V1 Real)
(declare-const v Real)
(assert (> V0 0))
(assert (<= V0 V))
(assert (<= V V1))
(assert (<= v V))
(assert (> v 0))
(check-sat)
