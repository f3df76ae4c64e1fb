; TH-LAW, two limits measured: an error of measurement of at most ½ adds at most ½|d|
; an error of measurement of at most ½ adds at most ½|d|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const lower Real)
(declare-const upper Real)
(declare-const e Real)
(declare-const x Real)
(declare-const d Real)
(define-fun def1 () Real (ite (>= e 0) e (- e)))
(define-fun def2 () Real (ite (>= x lower) x lower))
(define-fun def3 () Real (ite (<= def2 upper) def2 upper))
(define-fun def4 () Real (+ x e))
(define-fun def5 () Real (ite (>= def4 lower) def4 lower))
(define-fun def6 () Real (ite (<= def5 upper) def5 upper))
(define-fun def7 () Real (ite (>= d 0) d (- d)))
(assert (<= lower 0))
(assert (<= 0 upper))
(assert (<= def1 (/ 1 2)))
; what would contradict the goal
(assert (not (<= (* (- def3 def6) d) (/ def7 2))))
(check-sat)
