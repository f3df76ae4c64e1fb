; TH-COUNTS, counted linear least: wherever within their ticks the positions are, generated energy is not beyond the end that the code finds
; wherever within their ticks the positions are, generated energy is not beyond the end that the code finds
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x Real)
(declare-const y Real)
(declare-const f Real)
(declare-const k Real)
(define-fun def1 () Real (- (/ 1 2) f))
(define-fun def2 () Real (ite (>= def1 k) def1 k))
(define-fun def3 () Real (+ k 1))
(define-fun def4 () Real (ite (<= def2 def3) def2 def3))
(define-fun def5 () Real (ite (>= f 0) f 0))
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
; what would contradict the goal
(assert (not (<= (- (* def4 (+ f (/ (- def4 1) 2))) def5) (- (* (+ k y) (+ f (/ (- (+ k y) 1) 2))) (* x (+ f (/ (- x 1) 2)))))))
(check-sat)
