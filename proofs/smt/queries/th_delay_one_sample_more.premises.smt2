; TH-DELAY, one sample more: if k samples are paid for, k + 1 are: the induction over the delay
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const d Real)
(declare-const s Real)
(declare-const k Real)
(declare-const w Real)
(declare-const w1 Real)
(assert (<= (* d s) (- (+ (* k (* d d)) w) w1)))
(check-sat)
