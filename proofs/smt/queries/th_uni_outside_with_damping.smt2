; TH-UNI, outside with damping: outside of a one-sided wall there is no force, not even that of the damper; inside there is all of it
; outside of a one-sided wall there is no force, not even that of the damper; inside there is all of it
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const q Real)
(declare-const B Real)
(declare-const q1 Real)
(define-fun def1 () Real (- 1))
(define-fun def2 () Real (ite (>= q def1) q def1))
(define-fun def3 () Real (ite (<= def2 0) def2 0))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(assert (or (= floor4 def1) (= floor4 0)))
; what would contradict the goal
(assert (not (and (or (<= 0 q) (= (- (* (+ (* 1 q) (* (- B) (- q1 q))) (+ floor4 1))) 0)) (or (> 0 q) (= (- (* (+ (* 1 q) (* (- B) (- q1 q))) (+ floor4 1))) (- (+ q (* B (- q q1)))))))))
(check-sat)
