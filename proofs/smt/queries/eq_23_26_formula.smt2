; EQ-23..26, formula: the least that a step dissipates is βd²/Δτ + σ|d|
; the least that a step dissipates is βd²/Δτ + σ|d|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const t1 Real)
(declare-const d1 Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (ite (>= d1 0) d1 (- d1)))
(assert (> t1 0))
; what would contradict the goal
(assert (not (= (* def1 (+ (* beta (/ def1 t1)) sigma)) (+ (* beta (/ (* d1 d1) t1)) (* sigma def1)))))
(check-sat)
