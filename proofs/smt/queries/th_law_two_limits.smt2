; TH-LAW, two limits: with two limits of its force it generates at most ½d² + ½|d|: the law held from the position itself, at most ½d²
; with two limits of its force it generates at most ½d² + ½|d|: the law held from the position itself, at most ½d²
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const lower Real)
(declare-const upper Real)
(declare-const x Real)
(declare-const d Real)
(define-fun def1 () Real (+ x d))
(define-fun def2 () Real (ite (>= def1 lower) def1 lower))
(define-fun def3 () Real (ite (<= def2 upper) def2 upper))
(define-fun def4 () Real (ite (>= x lower) x lower))
(define-fun def5 () Real (ite (<= def4 upper) def4 upper))
(assert (<= lower 0))
(assert (<= 0 upper))
; what would contradict the goal
(assert (not (<= (- (- (- (* (+ x d) def3) (/ (* def3 def3) 2)) (- (* x def5) (/ (* def5 def5) 2))) (* def5 d)) (/ (* d d) 2))))
(check-sat)
