; TH-DAMP, cost: the step pays B·d² + B·|d|, what was stored before pays the rest
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const q Real)
(declare-const d2 Real)
(define-fun def1 () Real (- q d2))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(assert (<= 0 B))
(assert (<= def2 1))
(check-sat)
