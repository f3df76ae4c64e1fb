; TH-LAW, staircase: within a tick the potential of the quantized law rises by the force at its middle
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const lower Real)
(declare-const upper Real)
(declare-const x0 Real)
(declare-const x1 Real)
(define-fun def1 () Real (- (/ 1.0 2) upper))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (- (/ 1.0 2) (- lower)))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(declare-const floor5 Int) ; floor of x0
(assert (and (<= (to_real floor5) x0) (< x0 (+ (to_real floor5) 1))))
(declare-const floor6 Int) ; floor of x1
(assert (and (<= (to_real floor6) x1) (< x1 (+ (to_real floor6) 1))))
(assert (<= lower 0.0))
(assert (<= 0.0 upper))
(assert (<= 0.0 (- (to_real floor2))))
(assert (<= 0.0 (- (to_real floor4))))
(assert (or (<= (- (to_real floor2)) (to_real floor5)) (<= (+ (to_real floor5) 1.0) (- (to_real floor2)))))
(assert (or (<= (- (to_real floor4)) (- (+ (to_real floor5) 1.0))) (<= (+ (- (+ (to_real floor5) 1.0)) 1.0) (- (to_real floor4)))))
(assert (or (<= 0.0 (to_real floor5)) (<= (+ (to_real floor5) 1.0) 0.0)))
(assert (or (<= (- (to_real floor2)) (+ (to_real floor5) 1.0)) (<= (+ (+ (to_real floor5) 1.0) 1.0) (- (to_real floor2)))))
(assert (or (<= (- (to_real floor4)) (- (+ (+ (to_real floor5) 1.0) 1.0))) (<= (+ (- (+ (+ (to_real floor5) 1.0) 1.0)) 1.0) (- (to_real floor4)))))
(assert (or (<= 0.0 (+ (to_real floor5) 1.0)) (<= (+ (+ (to_real floor5) 1.0) 1.0) 0.0)))
(assert (<= x0 x1))
(assert (= (to_real floor6) (to_real floor5)))
(check-sat)
