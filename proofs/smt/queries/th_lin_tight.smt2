; TH-LIN, tight: downwards from a tick the bound is reached; upwards it is missed by (1 − ρ₀)d
; downwards from a tick the bound is reached; upwards it is missed by (1 − ρ₀)d
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x1 Real)
(declare-const x0 Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(declare-const floor3 Real) ; floor of x0
(assert (and (<= floor3 x0) (< x0 (+ floor3 1))))
(assert (or (> 0 (- x1 x0)) (> (- x1 x0) 0)))
; what would contradict the goal
(assert (not (and (or (> (- x1 x0) 0) (= (- (/ (* def2 (+ def2 1)) 2) (/ (* def1 (- (+ def1 (+ (- x0 floor3) (- x0 floor3))) 1)) 2)) (* (- x0 floor3) def2))) (or (> 0 def1) (= (- (/ (* def2 (+ def2 1)) 2) (/ (* def1 (- (+ def1 (+ (- x0 floor3) (- x0 floor3))) 1)) 2)) (* (- 1 (- x0 floor3)) def1))))))
(check-sat)
