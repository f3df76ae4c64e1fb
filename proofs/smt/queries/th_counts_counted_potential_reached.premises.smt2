; TH-COUNTS, counted potential reached: it is least where the potential's slope is the excess, and most at an end
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const y Real)
(declare-const f Real)
(declare-const end Real)
(define-fun def1 () Real (- f end))
(define-fun def2 () Real (ite (>= def1 0) def1 0))
(define-fun def3 () Real (ite (<= def2 1) def2 1))
(assert (= y def3))
(check-sat)
