; TH-LTI, two poles inside: where |d₂| < |d₀| and |d₁| < |d₀ + d₂| every root, real or not, is inside the unit circle
; where |d₂| < |d₀| and |d₁| < |d₀ + d₂| every root, real or not, is inside the unit circle
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const d0 Real)
(declare-const x Real)
(declare-const y Real)
(declare-const d1 Real)
(declare-const d2 Real)
(define-fun def1 () Real (ite (>= d0 0) d0 (- d0)))
(define-fun def2 () Real (ite (>= d2 0) d2 (- d2)))
(define-fun def3 () Real (+ d0 d2))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(define-fun def5 () Real (ite (>= d1 0) d1 (- d1)))
(assert (or (> 0 d0) (> d0 0)))
(assert (and (= (+ (+ (* d0 (- (* x x) (* y y))) (* d1 x)) d2) 0) (= (* y (+ (* d0 (+ x x)) d1)) 0)))
(assert (and (> def1 def2) (> def4 def5)))
; what would contradict the goal
(assert (<= 1 (+ (* x x) (* y y))))
(check-sat)
