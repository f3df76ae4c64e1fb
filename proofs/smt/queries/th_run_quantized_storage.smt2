; TH-RUN, quantized storage: against the paper's own storage the account is the same up to 1/8
; against the paper's own storage the account is the same up to 1/8
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const mu Real)
(declare-const v Real)
(declare-const x Real)
(declare-const floor1 Real) ; floor of x
(assert (and (<= floor1 x) (< x (+ floor1 1))))
(assert (> mu 0))
; what would contradict the goal
(assert (not (and (<= 0 (- (+ (/ (* mu (* v v)) 2) (+ (/ (* x x) 2) (/ (* (- x floor1) (- 1 (- x floor1))) 2))) (+ (/ (* mu (* v v)) 2) (/ (* x x) 2)))) (<= (- (+ (/ (* mu (* v v)) 2) (+ (/ (* x x) 2) (/ (* (- x floor1) (- 1 (- x floor1))) 2))) (+ (/ (* mu (* v v)) 2) (/ (* x x) 2))) (/ 1 8)))))
(check-sat)
