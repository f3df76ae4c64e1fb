; TH-LAW, two limits sum: both together are what the law generates
; both together are what the law generates
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x Real)
(declare-const d Real)
(declare-const lower Real)
(declare-const upper Real)
(declare-const e Real)
(define-fun def1 () Real (+ x d))
(define-fun def2 () Real (ite (>= def1 lower) def1 lower))
(define-fun def3 () Real (ite (<= def2 upper) def2 upper))
(define-fun def4 () Real (ite (>= x lower) x lower))
(define-fun def5 () Real (ite (<= def4 upper) def4 upper))
(define-fun def6 () Real (+ x e))
(define-fun def7 () Real (ite (>= def6 lower) def6 lower))
(define-fun def8 () Real (ite (<= def7 upper) def7 upper))
; what would contradict the goal
(assert (not (= (+ (- (- (- (* (+ x d) def3) (/ (* def3 def3) 2)) (- (* x def5) (/ (* def5 def5) 2))) (* def5 d)) (* (- def5 def8) d)) (- (- (- (* def1 def3) (/ (* def3 def3) 2)) (- (* x def5) (/ (* def5 def5) 2))) (* def8 d)))))
(check-sat)
