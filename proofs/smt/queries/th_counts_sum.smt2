; TH-COUNTS, sum: Σ E_gᴸ over two intervals is E_g of the first and E_gᴸ of the second, from the first residue on
; Σ E_gᴸ over two intervals is E_g of the first and E_gᴸ of the second, from the first residue on
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const x2 Real)
(declare-const floor1 Real) ; floor of x
(assert (and (<= floor1 x) (< x (+ floor1 1))))
(declare-const floor2 Real) ; floor of x1
(assert (and (<= floor2 x1) (< x1 (+ floor2 1))))
(declare-const floor3 Real) ; floor of x0
(assert (and (<= floor3 x0) (< x0 (+ floor3 1))))
(assert (= floor1 floor2))
(assert (= (- x floor1) (- x0 floor3)))
; what would contradict the goal
(assert (not (= (+ (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 floor3) (- x0 floor3))) 1)) 2) (/ (* (- x2 x1) (- (+ (- x2 x1) (+ (- x1 floor2) (- x1 floor2))) 1)) 2)) (+ (/ (* (- floor2 floor3) (- (+ (- floor2 floor3) (+ (- x1 floor2) (- x1 floor2))) 1)) 2) (/ (* (- x2 x) (- (+ (- x2 x) (+ (- x floor1) (- x floor1))) 1)) 2)))))
(check-sat)
