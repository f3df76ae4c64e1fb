; EQ-23..26, constant velocity: at constant velocity the least is what is dissipated
; not so over twice the time
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const t1 Real)
(declare-const v Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (ite (>= v 0) v (- v)))
(define-fun def2 () Real (* v t1))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
(assert (> t1 0))
; what would contradict the goal
(assert (not (= (* (* def1 (+ (* beta def1) sigma)) t1) (* def3 (+ (* beta (/ def3 (+ t1 t1))) sigma)))))
(check-sat)
