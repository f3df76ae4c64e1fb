; TH-LTI, filtered damping step: friction less what the command draws and the filter stores is B times what the step before has to spare, and what friction has beyond the cost: not below zero where β is the cost or more
; friction less what the command draws and the filter stores is B times what the step before has to spare, and what friction has beyond the cost: not below zero where β is the cost or more
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const a Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const beta Real)
(declare-const sigma Real)
(declare-const w Real)
(declare-const stored Real)
(declare-const share Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
; what would contradict the goal
(assert (not (= (- (- (* def2 (+ (* beta def2) sigma)) (+ (* (- (+ x0 (* B w))) def1) (/ (- (* x1 x1) (* x0 x0)) 2))) (* B stored)) (+ (+ (* B (- (+ (* w def1) (* share (* def1 def1))) stored)) (* (- (- beta (/ 1 2)) (* B share)) (* def1 def1))) (* sigma def2)))))
(check-sat)
