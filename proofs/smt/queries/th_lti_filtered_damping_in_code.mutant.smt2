; TH-LTI, filtered damping in code: the code's command is the position and B times the filter's state
; not with another state
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const a Real)
(declare-const x1 Real)
(declare-const w Real)
(declare-const x0 Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
; what would contradict the goal
(assert (not (= (+ (* 1 x1) (+ (- 0 (* (- a) (* B w))) (* (- (* B (- 1 a))) (- x0 x1)))) (+ x1 (* B w)))))
(check-sat)
