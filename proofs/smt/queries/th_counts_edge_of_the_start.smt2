; TH-COUNTS, edge of the start: while the start moves generated energy is −½d² + (F + ξ₁)d
; while the start moves generated energy is −½d² + (F + ξ₁)d
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const F Real)
(declare-const x Real)
(declare-const y Real)
(declare-const floor1 Real) ; floor of x
(assert (and (<= floor1 x) (< x (+ floor1 1))))
; what would contradict the goal
(assert (not (= (+ (* (- F (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2)) (+ (* (- (/ 1 2)) (* (- y x) (- y x))) (* (+ F y) (- y x))))))
(check-sat)
