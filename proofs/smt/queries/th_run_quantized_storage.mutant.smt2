; TH-RUN, quantized storage: against the paper's own storage the account is the same up to 1/8
; not exactly
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const mu Real)
(declare-const v Real)
(declare-const x Real)
(declare-const floor1 Int) ; floor of x
(assert (and (<= (to_real floor1) x) (< x (+ (to_real floor1) 1))))
(assert (> mu 0.0))
; what would contradict the goal
(assert (not (= (+ (/ (* mu (* v v)) 2) (+ (/ (* x x) 2) (/ (* (- x (to_real floor1)) (- 1.0 (- x (to_real floor1)))) 2))) (+ (/ (* mu (* v v)) 2) (/ (* x x) 2)))))
(check-sat)
