; EQ-27, critical line: on the line (9) the margin is zero
; on the line (9) the margin is zero
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const beta Real)
(declare-const v Real)
; what would contradict the goal
(assert (not (= (+ (* (- beta (/ 1 2)) v) (- (- (/ 1 2) (* v (- beta (/ 1 2)))) (/ 1 2))) 0)))
(check-sat)
