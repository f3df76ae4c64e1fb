; TH-STIFF, at a speed with effects: with two samples of delay, damping and force steps the limit is exact too
; it is not that of the plain loop
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
(declare-const c Real)
(declare-const F Real)
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
; what would contradict the goal
(assert (not (and (or (not (<= 0 (+ (* (- b (+ (* (* K T) (+ (/ 1 2) 2)) B)) v) (- c (+ (+ (/ (* K Delta) 2) (* B (/ Delta T))) (/ F 2)))))) (<= K (/ (+ (* (- b (* (* 0 T) (+ (/ 1 2) 0))) v) (- c (/ (* 0 Delta) 2))) (+ (* (* (* 1 T) (+ (/ 1 2) 0)) v) (/ (* 1 Delta) 2))))) (or (not (<= K (/ (+ (* (- b (* (* 0 T) (+ (/ 1 2) 0))) v) (- c (/ (* 0 Delta) 2))) (+ (* (* (* 1 T) (+ (/ 1 2) 0)) v) (/ (* 1 Delta) 2))))) (<= 0 (+ (* (- b (+ (* (* K T) (+ (/ 1 2) 2)) B)) v) (- c (+ (+ (/ (* K Delta) 2) (* B (/ Delta T))) (/ F 2)))))))))
(check-sat)
