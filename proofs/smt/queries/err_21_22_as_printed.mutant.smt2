; ERR-21/22, as printed: E_g is at most ½d² + ½|d|
; it is where ρ₀ = ρ₁, as the paper's last step silently has it
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(declare-const floor2 Real) ; floor of x1
(assert (and (<= floor2 x1) (< x1 (+ floor2 1))))
(define-fun def3 () Real (- x1 x0))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(assert (= (- x0 floor1) (- x1 floor2)))
; what would contradict the goal
(assert (not (<= (/ (* (- floor2 floor1) (- (+ (- floor2 floor1) (+ (- x1 floor2) (- x1 floor2))) 1)) 2) (/ (* def4 (+ def4 1)) 2))))
(check-sat)
