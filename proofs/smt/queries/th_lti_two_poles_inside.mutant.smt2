; TH-LTI, two poles inside: where |d₂| < |d₀| and |d₁| < |d₀ + d₂| every root, real or not, is inside the unit circle
; else it need not be
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const d0 Real)
(declare-const x Real)
(declare-const y Real)
(declare-const d1 Real)
(declare-const d2 Real)
(assert (or (> 0 d0) (> d0 0)))
(assert (and (= (+ (+ (* d0 (- (* x x) (* y y))) (* d1 x)) d2) 0) (= (* y (+ (* d0 (+ x x)) d1)) 0)))
; what would contradict the goal
(assert (<= 1 (+ (* x x) (* y y))))
(check-sat)
