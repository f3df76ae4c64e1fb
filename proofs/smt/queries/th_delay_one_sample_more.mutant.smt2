; TH-DELAY, one sample more: if k samples are paid for, k + 1 are: the induction over the delay
; not otherwise
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const d Real)
(declare-const s Real)
(declare-const old Real)
(declare-const k Real)
(declare-const w Real)
(declare-const w1 Real)
; what would contradict the goal
(assert (not (<= (* d (+ s old)) (+ (- (+ (* (+ k 1) (* d d)) w) w1) (/ (- (* old old) (* d d)) 2)))))
(check-sat)
