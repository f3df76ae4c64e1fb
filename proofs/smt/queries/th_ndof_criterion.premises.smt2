; TH-NDOF, criterion: friction less the bound is dᵀ(diag(b) − (T/2)K)d/T and what each joint has to spare
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const T Real)
(assert (> T 0))
(check-sat)
