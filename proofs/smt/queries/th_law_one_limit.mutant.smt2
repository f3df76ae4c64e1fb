; TH-LAW, one limit: a spring with one limit of its force generates at most ½d² + ½|d|
; not with a larger error of measurement
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const lower Real)
(declare-const x Real)
(declare-const d Real)
(declare-const e Real)
(define-fun def1 () Real (+ x d))
(define-fun def2 () Real (ite (>= def1 lower) def1 lower))
(define-fun def3 () Real (ite (>= x lower) x lower))
(define-fun def4 () Real (+ x e))
(define-fun def5 () Real (ite (>= def4 lower) def4 lower))
(define-fun def6 () Real (ite (>= d 0) d (- d)))
(assert (<= lower 0))
; what would contradict the goal
(assert (not (<= (- (- (- (* (+ x d) def2) (/ (* def2 def2) 2)) (- (* x def3) (/ (* def3 def3) 2))) (* def5 d)) (/ (* def6 (+ def6 1)) 2))))
(check-sat)
