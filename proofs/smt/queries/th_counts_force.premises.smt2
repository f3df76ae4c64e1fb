; TH-COUNTS, force: under a force between two ends generated energy is between its values under these
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const F0 Real)
(declare-const F Real)
(declare-const F1 Real)
(assert (<= F0 F))
(assert (<= F F1))
(check-sat)
