; TH-TELESCOPE, sum: the differences over two runs add up to that of both
; the differences over two runs add up to that of both
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const x2 Real)
(declare-const floor1 Real) ; floor of x1
(assert (and (<= floor1 x1) (< x1 (+ floor1 1))))
(declare-const floor2 Real) ; floor of x0
(assert (and (<= floor2 x0) (< x0 (+ floor2 1))))
(declare-const floor3 Real) ; floor of x2
(assert (and (<= floor3 x2) (< x2 (+ floor3 1))))
; what would contradict the goal
(assert (not (= (+ (- (/ (* (- x1 floor1) (- 1 (- x1 floor1))) 2) (/ (* (- x0 floor2) (- 1 (- x0 floor2))) 2)) (- (/ (* (- x2 floor3) (- 1 (- x2 floor3))) 2) (/ (* (- x1 floor1) (- 1 (- x1 floor1))) 2))) (- (/ (* (- x2 floor3) (- 1 (- x2 floor3))) 2) (/ (* (- x0 floor2) (- 1 (- x0 floor2))) 2)))))
(check-sat)
