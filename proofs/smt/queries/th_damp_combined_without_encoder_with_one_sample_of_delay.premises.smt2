; TH-DAMP, combined without encoder with one sample of delay: encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
