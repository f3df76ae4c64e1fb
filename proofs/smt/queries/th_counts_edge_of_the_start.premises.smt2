; TH-COUNTS, edge of the start: while the start moves generated energy is −½d² + (F + ξ₁)d
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
