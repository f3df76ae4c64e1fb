; TH-LTI, two poles: two poles are stable in the code exactly where |d₂| < |d₀| and |d₁| < |d₀ + d₂|
; two poles are stable in the code exactly where |d₂| < |d₀| and |d₁| < |d₀ + d₂|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const d0 Real)
(declare-const d2 Real)
(declare-const d1 Real)
(define-fun def1 () Real (ite (>= d0 0) d0 (- d0)))
(define-fun def2 () Real (ite (>= d2 0) d2 (- d2)))
(define-fun def3 () Real (- d0 (* (/ d2 d0) d2)))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(define-fun def5 () Real (- d1 (* (/ d2 d0) d1)))
(define-fun def6 () Real (ite (>= def5 0) def5 (- def5)))
(define-fun def7 () Real (+ d0 d2))
(define-fun def8 () Real (ite (>= def7 0) def7 (- def7)))
(define-fun def9 () Real (ite (>= d1 0) d1 (- d1)))
(assert (or (> 0 d0) (> d0 0)))
; what would contradict the goal
(assert (not (and (or (not (and (> (- def1 def2) 0) (> (- def4 def6) 0))) (and (> def1 def2) (> def8 def9))) (or (not (and (> def1 def2) (> def8 def9))) (and (> (- def1 def2) 0) (> (- def4 def6) 0))))))
(check-sat)
