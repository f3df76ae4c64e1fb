; TH-INTERVAL, row of any force: the account is of the force that was held: its work, and the change of the wall's potential
; the account is of the force that was held: its work, and the change of the wall's potential
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const u Real)
(declare-const x0 Real)
(declare-const x1 Real)
(declare-const L Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(define-fun def2 () Real (- L))
(define-fun def3 () Real (ite (>= 0 def2) 0 def2))
(define-fun def4 () Real (ite (>= x1 def3) x1 def3))
(define-fun def5 () Real (ite (<= def4 L) def4 L))
(define-fun def6 () Real (ite (>= x0 def3) x0 def3))
(define-fun def7 () Real (ite (<= def6 L) def6 L))
; what would contradict the goal
(assert (not (and (= (+ (* (- u (- (+ floor1 (/ 1 2)))) (- x1 x0)) (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 floor1) (- x0 floor1))) 1)) 2)) (- (+ (* u (- x1 x0)) (- (* x1 x1) (/ (* x1 x1) 2))) (- (* x0 x0) (/ (* x0 x0) 2)))) (= (+ (* (- u (- x0)) (- x1 x0)) (/ (* (- x1 x0) (- x1 x0)) 2)) (- (+ (* u (- x1 x0)) (- (* x1 x1) (/ (* x1 x1) 2))) (- (* x0 x0) (/ (* x0 x0) 2)))) (= (- (+ (* u (- x1 x0)) (- (* x1 def5) (/ (* def5 def5) 2))) (- (* x0 def7) (/ (* def7 def7) 2))) (- (+ (* u (- x1 x0)) (- (* x1 def5) (/ (* def5 def5) 2))) (- (* x0 def7) (/ (* def7 def7) 2)))))))
(check-sat)
