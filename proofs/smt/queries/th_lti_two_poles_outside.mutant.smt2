; TH-LTI, two poles outside: where two real roots, or a root and its conjugate, are inside the unit circle, |d₂| < |d₀| and |d₁| < |d₀ + d₂|
; else they need not be
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const d0 Real)
(declare-const d2 Real)
(declare-const d1 Real)
(define-fun def1 () Real (ite (>= d0 0) d0 (- d0)))
(define-fun def2 () Real (ite (>= d2 0) d2 (- d2)))
(define-fun def3 () Real (+ d0 d2))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(define-fun def5 () Real (ite (>= d1 0) d1 (- d1)))
(assert (or (> 0 d0) (> d0 0)))
; what would contradict the goal
(assert (not (and (> def1 def2) (> def4 def5))))
(check-sat)
