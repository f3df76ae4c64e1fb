; TH-DAC, cost: it adds at most ½δ|d|
; not for a larger error
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const delta Real)
(declare-const r Real)
(declare-const d Real)
(define-fun def1 () Real (ite (>= d 0) d (- d)))
(assert (> delta 0))
; what would contradict the goal
(assert (not (<= (* r d) (* (/ delta 2) def1))))
(check-sat)
