; TH-START, memory: ½μV² is the storage at the start, with what the controller remembers
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const mu Real)
(assert (> mu 0))
(check-sat)
