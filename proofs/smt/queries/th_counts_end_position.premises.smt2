; TH-COUNTS, end position: generated energy at a position between two ends is between its values at these and where the wall balances the force
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const lo Real)
(declare-const x Real)
(declare-const hi Real)
(assert (<= lo x))
(assert (<= x hi))
(check-sat)
