; TH-STIFF, period and resolution: the longest period and the coarsest encoder bring the margin to zero
; the longest period and the coarsest encoder bring the margin to zero
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
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
(assert (> (/ (- b (+ (* (* 0 1) (+ (/ 1 2) 2)) B)) (* (* (* 1 1) (+ (/ 1 2) 2)) K)) 0))
(assert (> B 0))
; what would contradict the goal
(assert (not (and (= (- b (+ (* (* K (/ (- b (+ (* (* 0 1) (+ (/ 1 2) 2)) B)) (* (* (* 1 1) (+ (/ 1 2) 2)) K))) (+ (/ 1 2) 2)) B)) 0) (= (- c (+ (+ (/ (* K (+ Delta (/ (- c (+ (+ (/ (* K Delta) 2) (* B (/ Delta T))) (/ F 2))) (- (+ (+ (/ (* K 1) 2) (* B (/ 1 T))) (/ F 2)) (+ (+ (/ (* K 0) 2) (* B (/ 0 T))) (/ F 2)))))) 2) (* B (/ (+ Delta (/ (- c (+ (+ (/ (* K Delta) 2) (* B (/ Delta T))) (/ F 2))) (- (+ (+ (/ (* K 1) 2) (* B (/ 1 T))) (/ F 2)) (+ (+ (/ (* K 0) 2) (* B (/ 0 T))) (/ F 2))))) T))) (/ F 2))) 0))))
(check-sat)
