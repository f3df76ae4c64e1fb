; TH-JITTER, bound: E_d − E_gᴸ is at least the bound in an interval of any length
; E_d − E_gᴸ is at least the bound in an interval of any length
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const dtau Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(declare-const floor3 Real) ; floor of x0
(assert (and (<= floor3 x0) (< x0 (+ floor3 1))))
(assert (> dtau 0))
; what would contradict the goal
(assert (not (<= (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (/ (* def2 (+ def2 1)) 2)) (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (+ (* (- (- (+ floor3 (/ 1 2))) (- (+ floor3 (/ 1 2)))) def1) (/ (* def1 (- (+ def1 (+ (- x0 floor3) (- x0 floor3))) 1)) 2))))))
(check-sat)
