; TH-STIFF, period and resolution: the longest period and the coarsest encoder bring the margin to zero
; the premises can be met
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
(assert (> (/ (- b (+ (* (* 0 1) (+ (/ 1 2) 2)) B)) (* (* (* 1 1) (+ (/ 1 2) 2)) K)) 0))
(assert (> B 0))
(check-sat)
