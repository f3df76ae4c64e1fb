; TH-DELAY, one sample more: if k samples are paid for, k + 1 are: the induction over the delay
; if k samples are paid for, k + 1 are: the induction over the delay
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const d Real)
(declare-const s Real)
(declare-const k Real)
(declare-const w Real)
(declare-const w1 Real)
(declare-const old Real)
(assert (<= (* d s) (- (+ (* k (* d d)) w) w1)))
; what would contradict the goal
(assert (not (<= (* d (+ s old)) (+ (- (+ (* (+ k 1) (* d d)) w) w1) (/ (- (* old old) (* d d)) 2)))))
(check-sat)
