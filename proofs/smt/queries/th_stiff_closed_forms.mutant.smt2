; TH-STIFF, closed forms: without effects the limits are 2b/T, 2c/Δ and 2(bv + c)/(Tv + Δ)
; not b/T
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const Delta Real)
(declare-const v Real)
(declare-const b Real)
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
; what would contradict the goal
(assert (not (= (/ (- b (* (* 0 T) (+ (/ 1 2) 0))) (* (* 1 T) (+ (/ 1 2) 0))) (/ b T))))
(check-sat)
