; TH-JITTER, bound of 22: the bound is what friction dissipates less ½d² + ½|d|
; the bound is what friction dissipates less ½d² + ½|d|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const dtau Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(assert (> dtau 0))
; what would contradict the goal
(assert (not (= (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (/ (* def2 (+ def2 1)) 2)) (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (/ (* def2 (+ def2 1)) 2)))))
(check-sat)
