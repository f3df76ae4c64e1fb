; TH-DAC, rounding: rounding to steps of δ is off by at most ½δ
; not by at most ⅓δ
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const delta Real)
(declare-const u Real)
(define-fun def1 () Real (+ (/ (* u 1.0) delta) (/ 1.0 2)))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (- (/ (* (to_real floor2) delta) 1.0) u))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(assert (> delta 0.0))
(assert (= delta (/ 1.0 1.0)))
(assert (= u (/ 1.0 2.0)))
; what would contradict the goal
(assert (not (<= def4 (* delta (/ 1.0 3.0)))))
(check-sat)
