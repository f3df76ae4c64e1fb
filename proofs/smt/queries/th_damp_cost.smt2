; TH-DAMP, cost: the step pays B·d² + B·|d|, what was stored before pays the rest
; the step pays B·d² + B·|d|, what was stored before pays the rest
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const q Real)
(declare-const d2 Real)
(declare-const d Real)
(declare-const d1 Real)
(define-fun def1 () Real (- q d2))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(define-fun def3 () Real (ite (>= d 0) d (- d)))
(assert (<= 0 B))
(assert (<= def2 1))
; what would contradict the goal
(assert (not (<= (- (* (* B q) d)) (+ (+ (* B (* d d)) (* B def3)) (- (/ (* B (+ (+ 0 (* d1 d1)) (* d2 d2))) 2) (/ (* B (+ (+ 0 (* d d)) (* d1 d1))) 2))))))
(check-sat)
