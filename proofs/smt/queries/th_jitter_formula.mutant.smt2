; TH-JITTER, formula: the bound is (β/Δτ − ½)d² + (σ − ½)|d|
; with Δτ of one for all it is another
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const dtau Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(assert (> dtau 0))
; what would contradict the goal
(assert (not (= (- (* def2 (+ (* beta def2) sigma)) (/ (* def2 (+ def2 1)) 2)) (+ (* (- (/ beta dtau) (/ 1 2)) (* def1 def1)) (* (- sigma (/ 1 2)) def2)))))
(check-sat)
