; TH-LAW, lipschitz: the law is nowhere stiffer than the wall
; nor is it half as stiff
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const lower Real)
(declare-const upper Real)
(declare-const x Real)
(declare-const d Real)
(define-fun def1 () Real (+ x d))
(define-fun def2 () Real (ite (>= def1 lower) def1 lower))
(define-fun def3 () Real (ite (<= def2 upper) def2 upper))
(define-fun def4 () Real (ite (>= x lower) x lower))
(define-fun def5 () Real (ite (<= def4 upper) def4 upper))
(define-fun def6 () Real (- def3 def5))
(define-fun def7 () Real (ite (>= def6 0) def6 (- def6)))
(define-fun def8 () Real (ite (>= d 0) d (- d)))
(assert (<= lower 0))
(assert (<= 0 upper))
; what would contradict the goal
(assert (not (<= def7 (/ def8 2))))
(check-sat)
