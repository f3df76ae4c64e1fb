; TH-INTERVAL, whole: where (8) holds, no more is generated than dissipated
; not where (8) does not hold
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const dtau Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(declare-const floor3 Int) ; floor of x0
(assert (and (<= (to_real floor3) x0) (< x0 (+ (to_real floor3) 1))))
(assert (> dtau 0.0))
(assert (<= dtau 1.0))
; what would contradict the goal
(assert (not (<= 0.0 (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (+ (* (- (- (+ (to_real floor3) (/ 1.0 2))) (- (+ (to_real floor3) (/ 1.0 2)))) def1) (/ (* def1 (- (+ def1 (+ (- x0 (to_real floor3)) (- x0 (to_real floor3)))) 1.0)) 2))))))
(check-sat)
