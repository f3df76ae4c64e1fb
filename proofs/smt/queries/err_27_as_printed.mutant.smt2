; ERR-27, as printed: where (8) holds, E_g is at most E_d
; against the linear spring it is
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const beta Real)
(declare-const sigma Real)
(declare-const dtau Real)
(declare-const x1 Real)
(declare-const x0 Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(declare-const floor3 Real) ; floor of x0
(assert (and (<= floor3 x0) (< x0 (+ floor3 1))))
(assert (<= 0 beta))
(assert (<= 0 sigma))
(assert (> dtau 0))
(assert (<= dtau 1))
(assert (<= 0 (+ (* (- beta (* (* 1 1) (+ (/ 1 2) 0))) (/ def2 dtau)) (- sigma (/ (* 1 1) 2)))))
; what would contradict the goal
(assert (not (<= 0 (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (+ (* (- (- (+ floor3 (/ 1 2))) (- (+ floor3 (/ 1 2)))) def1) (/ (* def1 (- (+ def1 (+ (- x0 floor3) (- x0 floor3))) 1)) 2))))))
(check-sat)
