; TH-LTI, two poles outside: where two real roots, or a root and its conjugate, are inside the unit circle, |d₂| < |d₀| and |d₁| < |d₀ + d₂|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const d0 Real)
(declare-const d2 Real)
(declare-const x Real)
(declare-const y Real)
(declare-const d1 Real)
(define-fun def1 () Real (ite (>= x 0) x (- x)))
(define-fun def2 () Real (ite (>= y 0) y (- y)))
(assert (or (> 0 d0) (> d0 0)))
(assert (or (and (= d2 (* (* d0 x) y)) (= d1 (- (* d0 (+ x y)))) (> 1 def1) (> 1 def2)) (and (= d2 (* d0 (+ (* x x) (* y y)))) (= d1 (- (* d0 (+ x x)))) (> 1 (+ (* x x) (* y y))))))
(check-sat)
