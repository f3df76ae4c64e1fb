; TH-QUANT, tight: downwards from a tick the bound is reached
; (22) is passed
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(define-fun def2 () Real (- x1 x0))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(declare-const floor5 Real) ; floor of x1
(assert (and (<= floor5 x1) (< x1 (+ floor5 1))))
(assert (= floor1 x0))
(assert (> 0 (- x1 x0)))
(assert (or (and (= floor4 def3) (= (- floor5 floor1) (- floor4))) (= (- floor5 floor1) (- (+ floor4 1)))))
; what would contradict the goal
(assert (not (<= (/ (* (- floor5 floor1) (- (+ (- floor5 floor1) (+ (- x1 floor5) (- x1 floor5))) 1)) 2) (/ (* def3 (+ def3 1)) 2))))
(check-sat)
