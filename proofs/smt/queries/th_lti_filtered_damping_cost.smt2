; TH-LTI, filtered damping cost: the code charges ½ and B(1 − a)/(1 + a) of viscous friction
; the code charges ½ and B(1 − a)/(1 + a) of viscous friction
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const a Real)
(declare-const share Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
(assert (= (* share (+ 1 a)) (- 1 a)))
; what would contradict the goal
(assert (not (= (+ (/ 1 2) (* B (/ (- 1 a) (+ 1 a)))) (+ (/ 1 2) (* B share)))))
(check-sat)
