; TH-REGION, direction of speed bound: wherever it is in its tolerance, the criterion is no easier than at the easiest end and no harder than at the hardest
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const V0 Real)
(declare-const V Real)
(declare-const V1 Real)
(assert (> V0 0))
(assert (<= V0 V))
(assert (<= V V1))
(check-sat)
