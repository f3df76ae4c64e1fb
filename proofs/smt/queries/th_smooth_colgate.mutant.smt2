; TH-SMOOTH, colgate: without Coulomb friction the criterion is b ≥ KT/2
; not b ≥ KT
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const v Real)
(declare-const b Real)
(assert (> K 0))
(assert (> T 0))
(assert (> v 0))
; what would contradict the goal
(assert (not (and (or (not (<= 0 (+ (* (- b (* (* K T) (+ (/ 1 2) 0))) v) (- 0 0)))) (<= (* K T) b)) (or (not (<= (* K T) b)) (<= 0 (+ (* (- b (* (* K T) (+ (/ 1 2) 0))) v) (- 0 0)))))))
(check-sat)
