; EQ-27, critical line: on the line (9) the margin is zero
; at another speed it is not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const beta Real)
(declare-const v Real)
; what would contradict the goal
(assert (not (= (+ (* (- beta (/ 1 2)) (+ v v)) (- (- (/ 1 2) (* v (- beta (/ 1 2)))) (/ 1 2))) 0)))
(check-sat)
