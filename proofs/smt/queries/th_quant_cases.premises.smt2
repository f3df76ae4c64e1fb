; TH-QUANT, cases: with N = ⌊|d|⌋ the ticks crossed are N or N + 1, in the direction of d
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
