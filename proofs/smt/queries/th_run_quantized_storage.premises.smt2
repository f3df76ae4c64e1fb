; TH-RUN, quantized storage: against the paper's own storage the account is the same up to 1/8
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const mu Real)
(assert (> mu 0))
(check-sat)
