; TH-LTI, one pole stable: one pole is stable in the code exactly where its root is inside the unit circle
; one pole is stable in the code exactly where its root is inside the unit circle
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const d0 Real)
(declare-const x Real)
(declare-const d1 Real)
(define-fun def1 () Real (ite (>= d0 0) d0 (- d0)))
(define-fun def2 () Real (ite (>= d1 0) d1 (- d1)))
(define-fun def3 () Real (ite (>= x 0) x (- x)))
(assert (or (> 0 d0) (> d0 0)))
(assert (= (+ (* d0 x) d1) 0))
; what would contradict the goal
(assert (not (and (or (not (> (- def1 def2) 0)) (> 1 def3)) (or (<= 1 def3) (> (- def1 def2) 0)))))
(check-sat)
