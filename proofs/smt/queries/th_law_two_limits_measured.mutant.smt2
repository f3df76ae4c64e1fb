; TH-LAW, two limits measured: an error of measurement of at most ½ adds at most ½|d|
; a larger error adds more
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const lower Real)
(declare-const upper Real)
(declare-const x Real)
(declare-const e Real)
(declare-const d Real)
(define-fun def1 () Real (ite (>= x lower) x lower))
(define-fun def2 () Real (ite (<= def1 upper) def1 upper))
(define-fun def3 () Real (+ x e))
(define-fun def4 () Real (ite (>= def3 lower) def3 lower))
(define-fun def5 () Real (ite (<= def4 upper) def4 upper))
(define-fun def6 () Real (ite (>= d 0) d (- d)))
(assert (<= lower 0))
(assert (<= 0 upper))
; what would contradict the goal
(assert (not (<= (* (- def2 def5) d) (/ def6 2))))
(check-sat)
