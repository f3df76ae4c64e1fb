; TH-COUNTS, edge of the end: while the end moves generated energy is ½d² + (F + ξ₀)d
; while the end moves generated energy is ½d² + (F + ξ₀)d
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
(assert (not (= (+ (* (- F (- (+ floor1 (/ 1 2)))) (- y x)) (/ (* (- y x) (- (+ (- y x) (+ (- x floor1) (- x floor1))) 1)) 2)) (+ (* (/ 1 2) (* (- y x) (- y x))) (* (+ F x) (- y x))))))
(check-sat)
