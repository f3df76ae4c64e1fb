; TH-LTI, filtered damping in code: the code's command is the position and B times the filter's state
; the code's command is the position and B times the filter's state
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const a Real)
(declare-const w Real)
(declare-const x0 Real)
(declare-const x1 Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
; what would contradict the goal
(assert (not (and (= (+ (- 0 (* (- a) (* B w))) (* (- (* B (- 1 a))) (- x0 x1))) (* B (+ (* a w) (* (- 1 a) (- x1 x0))))) (= (+ (* 1 x1) (+ (- 0 (* (- a) (* B w))) (* (- (* B (- 1 a))) (- x0 x1)))) (+ x1 (+ (- 0 (* (- a) (* B w))) (* (- (* B (- 1 a))) (- x0 x1))))))))
(check-sat)
