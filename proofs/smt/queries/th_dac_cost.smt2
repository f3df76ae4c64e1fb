; TH-DAC, cost: it adds at most ½δ|d|
; it adds at most ½δ|d|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const delta Real)
(declare-const r Real)
(declare-const d Real)
(define-fun def1 () Real (ite (>= r 0) r (- r)))
(define-fun def2 () Real (ite (>= d 0) d (- d)))
(assert (> delta 0))
(assert (<= def1 (/ delta 2)))
; what would contradict the goal
(assert (not (<= (* r d) (* (/ delta 2) def2))))
(check-sat)
