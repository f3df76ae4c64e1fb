; TH-STIFF, best period: at a speed the margin times the period is a parabola that opens downwards, with its peak at the best period
; it is not flat
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const Delta Real)
(declare-const v Real)
(declare-const T1 Real)
(declare-const b Real)
(declare-const B Real)
(declare-const c Real)
(declare-const F Real)
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
(assert (> T1 0))
; what would contradict the goal
(assert (not (= (* (+ (* (- b (+ (* (* K T1) (+ (/ 1 2) 2)) B)) v) (- c (+ (+ (/ (* K Delta) 2) (* B (/ Delta T1))) (/ F 2)))) T1) (- (* (* (* K (+ 2 (/ 1 2))) v) (* (/ (+ (- c (+ (/ (* K Delta) 2) (/ F 2))) (* (- b B) v)) (+ (* (* (* K 1) (+ (/ 1 2) 2)) v) (* (* (* K 1) (+ (/ 1 2) 2)) v))) (/ (+ (- c (+ (/ (* K Delta) 2) (/ F 2))) (* (- b B) v)) (+ (* (* (* K 1) (+ (/ 1 2) 2)) v) (* (* (* K 1) (+ (/ 1 2) 2)) v))))) (* B Delta)))))
(check-sat)
