; TH-LAW, one limit: a spring with one limit of its force generates at most ½d² + ½|d|
; a spring with one limit of its force generates at most ½d² + ½|d|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const lower Real)
(declare-const e Real)
(declare-const x Real)
(declare-const d Real)
(define-fun def1 () Real (ite (>= e 0) e (- e)))
(define-fun def2 () Real (+ x d))
(define-fun def3 () Real (ite (>= def2 lower) def2 lower))
(define-fun def4 () Real (ite (>= x lower) x lower))
(define-fun def5 () Real (+ x e))
(define-fun def6 () Real (ite (>= def5 lower) def5 lower))
(define-fun def7 () Real (ite (>= d 0) d (- d)))
(assert (<= lower 0))
(assert (<= def1 (/ 1 2)))
; what would contradict the goal
(assert (not (<= (- (- (- (* (+ x d) def3) (/ (* def3 def3) 2)) (- (* x def4) (/ (* def4 def4) 2))) (* def6 d)) (/ (* def7 (+ def7 1)) 2))))
(check-sat)
