; TH-RUN, step: what was drawn and what is stored stay below the storage at the start, interval by interval
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const drawn Real)
(declare-const stored Real)
(declare-const first Real)
(declare-const generated Real)
(declare-const dissipated Real)
(assert (<= (+ drawn stored) first))
(assert (<= generated dissipated))
(check-sat)
