; EQ-27, formula: the surplus is (β − ½)d²/Δτ + (σ − ½)|d|
; with the sign of a half changed it is another
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const t1 Real)
(declare-const d1 Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (ite (>= d1 0) d1 (- d1)))
(assert (> t1 0))
; what would contradict the goal
(assert (not (= (* def1 (+ (* (- beta (/ 1 2)) (/ def1 t1)) (- sigma (/ 1 2)))) (+ (* (- beta (/ 1 2)) (/ (* d1 d1) t1)) (* (+ sigma (/ 1 2)) def1)))))
(check-sat)
