; TH-LTI, two poles outside: where two real roots, or a root and its conjugate, are inside the unit circle, |d₂| < |d₀| and |d₁| < |d₀ + d₂|
; where two real roots, or a root and its conjugate, are inside the unit circle, |d₂| < |d₀| and |d₁| < |d₀ + d₂|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const d0 Real)
(declare-const d2 Real)
(declare-const x Real)
(declare-const y Real)
(declare-const d1 Real)
(define-fun def1 () Real (ite (>= x 0) x (- x)))
(define-fun def2 () Real (ite (>= y 0) y (- y)))
(define-fun def3 () Real (ite (>= d0 0) d0 (- d0)))
(define-fun def4 () Real (ite (>= d2 0) d2 (- d2)))
(define-fun def5 () Real (+ d0 d2))
(define-fun def6 () Real (ite (>= def5 0) def5 (- def5)))
(define-fun def7 () Real (ite (>= d1 0) d1 (- d1)))
(assert (or (> 0 d0) (> d0 0)))
(assert (or (and (= d2 (* (* d0 x) y)) (= d1 (- (* d0 (+ x y)))) (> 1 def1) (> 1 def2)) (and (= d2 (* d0 (+ (* x x) (* y y)))) (= d1 (- (* d0 (+ x x)))) (> 1 (+ (* x x) (* y y))))))
; what would contradict the goal
(assert (not (and (> def3 def4) (> def6 def7))))
(check-sat)
