; TH-START, squares: compared in squares, the answer is that of every speed up to V
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const bound Real)
(declare-const v Real)
(assert (> bound 0))
(assert (> v 0))
(assert (<= v bound))
(check-sat)
