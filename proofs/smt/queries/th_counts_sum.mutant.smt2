; TH-COUNTS, sum: Σ E_gᴸ over two intervals is E_g of the first and E_gᴸ of the second, from the first residue on
; not from another residue on
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const x2 Real)
(declare-const floor1 Int) ; floor of x
(assert (and (<= (to_real floor1) x) (< x (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x1
(assert (and (<= (to_real floor2) x1) (< x1 (+ (to_real floor2) 1))))
(declare-const floor3 Int) ; floor of x0
(assert (and (<= (to_real floor3) x0) (< x0 (+ (to_real floor3) 1))))
(assert (= (to_real floor1) (to_real floor2)))
; what would contradict the goal
(assert (not (= (+ (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 (to_real floor3)) (- x0 (to_real floor3)))) 1.0)) 2) (/ (* (- x2 x1) (- (+ (- x2 x1) (+ (- x1 (to_real floor2)) (- x1 (to_real floor2)))) 1.0)) 2)) (+ (/ (* (- (to_real floor2) (to_real floor3)) (- (+ (- (to_real floor2) (to_real floor3)) (+ (- x1 (to_real floor2)) (- x1 (to_real floor2)))) 1.0)) 2) (/ (* (- x2 x) (- (+ (- x2 x) (+ (- x (to_real floor1)) (- x (to_real floor1)))) 1.0)) 2)))))
(check-sat)
