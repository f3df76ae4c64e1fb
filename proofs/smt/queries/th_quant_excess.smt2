; TH-QUANT, excess: the tight bound exceeds (22) by at most 1/8
; the tight bound exceeds (22) by at most 1/8
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x1 Real)
(declare-const x0 Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(declare-const floor3 Real) ; floor of def2
(assert (and (<= floor3 def2) (< def2 (+ floor3 1))))
; what would contradict the goal
(assert (not (<= (- (+ (/ (* def2 (+ def2 1)) 2) (/ (* (- def2 floor3) (- 1 (- def2 floor3))) 2)) (/ (* def2 (+ def2 1)) 2)) (/ 1 8))))
(check-sat)
