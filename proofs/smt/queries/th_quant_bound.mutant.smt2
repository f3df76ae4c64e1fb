; TH-QUANT, bound: E_g is at most ½d² + ½|d| + ½f(1 − f)
; the printed bound (22) is too small
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Real) ; floor of x1
(assert (and (<= floor1 x1) (< x1 (+ floor1 1))))
(declare-const floor2 Real) ; floor of x0
(assert (and (<= floor2 x0) (< x0 (+ floor2 1))))
(define-fun def3 () Real (- x1 x0))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(declare-const floor5 Real) ; floor of def4
(assert (and (<= floor5 def4) (< def4 (+ floor5 1))))
(assert (or (and (<= 0 (- x1 x0)) (or (= (- floor1 floor2) floor5) (= (- floor1 floor2) (+ floor5 1)))) (and (<= def3 0) (or (= (- floor1 floor2) (- floor5)) (= (- floor1 floor2) (- (+ floor5 1)))))))
; what would contradict the goal
(assert (not (<= (/ (* (- floor1 floor2) (- (+ (- floor1 floor2) (+ (- x1 floor1) (- x1 floor1))) 1)) 2) (/ (* def4 (+ def4 1)) 2))))
(check-sat)
