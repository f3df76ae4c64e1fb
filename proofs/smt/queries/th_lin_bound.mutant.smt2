; TH-LIN, bound: E_gᴸ is at most ½d² + ½|d|
; it can be above ½d² + ¼|d|
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(define-fun def2 () Real (- x1 x0))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
; what would contradict the goal
(assert (not (<= (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 (to_real floor1)) (- x0 (to_real floor1)))) 1.0)) 2) (- (/ (* def3 (+ def3 1.0)) 2) (/ (/ def3 2) 2)))))
(check-sat)
