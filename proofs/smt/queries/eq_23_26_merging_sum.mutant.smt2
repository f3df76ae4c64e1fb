; EQ-23..26, merging sum: what both dissipate is the sum
; not viscous friction alone
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
(assert (not (= (* def1 (+ (* beta (/ def1 t1)) sigma)) (* def1 (+ (* beta (/ def1 t1)) 0)))))
(check-sat)
