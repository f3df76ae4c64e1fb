; TH-REGION, all speeds: where the smaller coefficient is not negative the criterion holds at every speed
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const v Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (- beta (/ 1 2)))
(define-fun def2 () Real (- sigma (/ 1 2)))
(define-fun def3 () Real (ite (<= def1 def2) def1 def2))
(assert (> v 0))
(assert (<= 0 def3))
(check-sat)
