; TH-RUN, step: what was drawn and what is stored stay below the storage at the start, interval by interval
; what was drawn and what is stored stay below the storage at the start, interval by interval
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const drawn Real)
(declare-const stored Real)
(declare-const first Real)
(declare-const generated Real)
(declare-const dissipated Real)
(declare-const after Real)
(assert (<= (+ drawn stored) first))
(assert (<= generated dissipated))
; what would contradict the goal
(assert (not (<= (+ (- drawn (- (+ (- after stored) dissipated) generated)) after) first)))
(check-sat)
