; TH-DAC, cost: it adds at most ½δ|d|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const delta Real)
(declare-const r Real)
(define-fun def1 () Real (ite (>= r 0) r (- r)))
(assert (> delta 0))
(assert (<= def1 (/ delta 2)))
(check-sat)
