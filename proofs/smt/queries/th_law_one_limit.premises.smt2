; TH-LAW, one limit: a spring with one limit of its force generates at most ½d² + ½|d|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const lower Real)
(declare-const e Real)
(define-fun def1 () Real (ite (>= e 0) e (- e)))
(assert (<= lower 0))
(assert (<= def1 (/ 1 2)))
(check-sat)
