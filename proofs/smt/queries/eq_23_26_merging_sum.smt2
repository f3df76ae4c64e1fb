; EQ-23..26, merging sum: what both dissipate is the sum
; what both dissipate is the sum
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
(assert (not (= (* def1 (+ (* beta (/ def1 t1)) sigma)) (+ (* def1 (+ (* beta (/ def1 t1)) 0)) (* def1 (+ (* 0 (/ def1 t1)) sigma))))))
(check-sat)
