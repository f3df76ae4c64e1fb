; TH-QUANT, excess: the tight bound exceeds (22) by at most 1/8
; it can exceed it by more than 1/9
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(declare-const floor3 Int) ; floor of def2
(assert (and (<= (to_real floor3) def2) (< def2 (+ (to_real floor3) 1))))
; what would contradict the goal
(assert (not (<= (- (+ (/ (* def2 (+ def2 1.0)) 2) (/ (* (- def2 (to_real floor3)) (- 1.0 (- def2 (to_real floor3)))) 2)) (/ (* def2 (+ def2 1.0)) 2)) (/ 1.0 9.0))))
(check-sat)
