; ERR-IV-C, as printed: switching the wall on at a depth adds nothing to what is stored
; as printed: refuted by every model
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x Real)
; what would contradict the goal
(assert (not (<= (- (* x x) (/ (* x x) 2)) 0)))
(check-sat)
