; TH-NDOF, generated: what two joints generate is ½dᵀKd + Σ dᵢKᵢⱼΔⱼ(ρⱼ − ½)
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
