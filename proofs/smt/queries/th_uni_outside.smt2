; TH-UNI, outside: outside it pushes with nothing, and stores nothing
; outside it pushes with nothing, and stores nothing
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const x0 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(define-fun def2 () Real (+ floor1 (/ 1 2)))
(define-fun def3 () Real (ite (>= def2 0) def2 0))
(define-fun def4 () Real (ite (>= x0 0) x0 0))
(assert (<= floor1 (- 1)))
(assert (<= x0 0))
; what would contradict the goal
(assert (not (and (= (- def3) 0) (= (- (* x0 def4) (/ (* def4 def4) 2)) 0))))
(check-sat)
