; TH-STIFF, friction needed: the least friction brings the margin to zero
; twice of it does not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const Delta Real)
(declare-const v Real)
(declare-const b Real)
(declare-const B Real)
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
; what would contradict the goal
(assert (not (= (- (+ (- b (- b (+ (* (* K T) (+ (/ 1 2) 2)) B))) (- b (- b (+ (* (* K T) (+ (/ 1 2) 2)) B)))) (+ (* (* K T) (+ (/ 1 2) 2)) B)) 0)))
(check-sat)
