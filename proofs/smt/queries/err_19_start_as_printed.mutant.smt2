; ERR-19-start, as printed: the bound holds from any instant of an interval
; it does where the tick is still that of the sample
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const sample Real)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const floor1 Real) ; floor of sample
(assert (and (<= floor1 sample) (< sample (+ floor1 1))))
(declare-const floor2 Real) ; floor of x0
(assert (and (<= floor2 x0) (< x0 (+ floor2 1))))
(define-fun def3 () Real (- x1 x0))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(assert (<= sample x0))
(assert (<= x0 x1))
(assert (<= (- x1 sample) 1))
(assert (= floor1 floor2))
; what would contradict the goal
(assert (not (<= (- (+ (* (- (+ floor1 (/ 1 2))) (- x1 x0)) (/ (* x1 x1) 2)) (/ (* x0 x0) 2)) (/ (* def4 (+ def4 1)) 2))))
(check-sat)
