; TH-STIFF, up to a speed: K is admissible up to a speed exactly up to the limit
; the limit at the speed is not enough
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const Delta Real)
(declare-const v Real)
(declare-const c Real)
(declare-const b Real)
(define-fun def1 () Real (- c (/ (* K Delta) 2)))
(define-fun def2 () Real (+ (* (- b (* (* K T) (+ (/ 1 2) 0))) v) def1))
(define-fun def3 () Real (ite (<= def1 def2) def1 def2))
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
; what would contradict the goal
(assert (not (and (or (not (<= 0 def3)) (<= K (/ (+ (* (- b (* (* 0 T) (+ (/ 1 2) 0))) v) (- c (/ (* 0 Delta) 2))) (+ (* (* (* 1 T) (+ (/ 1 2) 0)) v) (/ (* 1 Delta) 2))))) (or (not (<= K (/ (+ (* (- b (* (* 0 T) (+ (/ 1 2) 0))) v) (- c (/ (* 0 Delta) 2))) (+ (* (* (* 1 T) (+ (/ 1 2) 0)) v) (/ (* 1 Delta) 2))))) (<= 0 def3)))))
(check-sat)
