; TH-DAMP, force: the damper adds B times the difference of two samples
; the damper adds B times the difference of two samples
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const q Real)
(declare-const B Real)
(declare-const q1 Real)
; what would contradict the goal
(assert (not (= (- (+ (* 1 q) (* (- B) (- q1 q)))) (- (+ q (* B (- q q1)))))))
(check-sat)
