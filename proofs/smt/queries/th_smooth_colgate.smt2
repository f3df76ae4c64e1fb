; TH-SMOOTH, colgate: without Coulomb friction the criterion is b ≥ KT/2
; without Coulomb friction the criterion is b ≥ KT/2
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const K Real)
(declare-const T Real)
(declare-const v Real)
(declare-const b Real)
(assert (> K 0))
(assert (> T 0))
(assert (> v 0))
; what would contradict the goal
(assert (not (and (or (not (<= 0 (+ (* (- b (* (* K T) (+ (/ 1 2) 0))) v) (- 0 0)))) (<= (/ (* K T) 2) b)) (or (not (<= (/ (* K T) 2) b)) (<= 0 (+ (* (- b (* (* K T) (+ (/ 1 2) 0))) v) (- 0 0)))))))
(check-sat)
