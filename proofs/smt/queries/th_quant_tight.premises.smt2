; TH-QUANT, tight: downwards from a tick the bound is reached
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Int) ; floor of x0
(assert (and (<= (to_real floor1) x0) (< x0 (+ (to_real floor1) 1))))
(define-fun def2 () Real (- x1 x0))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(declare-const floor5 Int) ; floor of x1
(assert (and (<= (to_real floor5) x1) (< x1 (+ (to_real floor5) 1))))
(assert (= (to_real floor1) x0))
(assert (> 0.0 (- x1 x0)))
(assert (or (and (= (to_real floor4) def3) (= (- (to_real floor5) (to_real floor1)) (- (to_real floor4)))) (= (- (to_real floor5) (to_real floor1)) (- (+ (to_real floor4) 1.0)))))
(check-sat)
