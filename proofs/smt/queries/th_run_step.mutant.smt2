; TH-RUN, step: what was drawn and what is stored stay below the storage at the start, interval by interval
; not when more is generated than dissipated
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const drawn Real)
(declare-const stored Real)
(declare-const first Real)
(declare-const after Real)
(declare-const dissipated Real)
(declare-const generated Real)
(assert (<= (+ drawn stored) first))
; what would contradict the goal
(assert (not (<= (+ (- drawn (- (+ (- after stored) dissipated) generated)) after) first)))
(check-sat)
