; TH-REGION, up to a speed: the margin up to a speed is the least of the margins up to it
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const v Real)
(declare-const bound Real)
(assert (> v 0))
(assert (<= v bound))
(check-sat)
