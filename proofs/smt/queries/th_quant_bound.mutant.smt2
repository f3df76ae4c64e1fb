; TH-QUANT, bound: E_g is at most ½d² + ½|d| + ½f(1 − f)
; the printed bound (22) is too small
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x1
(assert (and (<= (to_real floor1) x1) (< x1 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x0
(assert (and (<= (to_real floor2) x0) (< x0 (+ (to_real floor2) 1))))
(define-fun def3 () Real (- x1 x0))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(declare-const floor5 Int) ; floor of def4
(assert (and (<= (to_real floor5) def4) (< def4 (+ (to_real floor5) 1))))
(assert (or (and (<= 0.0 (- x1 x0)) (or (= (- (to_real floor1) (to_real floor2)) (to_real floor5)) (= (- (to_real floor1) (to_real floor2)) (+ (to_real floor5) 1.0)))) (and (<= def3 0.0) (or (= (- (to_real floor1) (to_real floor2)) (- (to_real floor5))) (= (- (to_real floor1) (to_real floor2)) (- (+ (to_real floor5) 1.0)))))))
; what would contradict the goal
(assert (not (<= (/ (* (- (to_real floor1) (to_real floor2)) (- (+ (- (to_real floor1) (to_real floor2)) (+ (- x1 (to_real floor1)) (- x1 (to_real floor1)))) 1.0)) 2) (/ (* def4 (+ def4 1.0)) 2))))
(check-sat)
