; TH-STIFF, best period: at a speed the margin times the period is a parabola that opens downwards, with its peak at the best period
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const Delta Real)
(declare-const v Real)
(declare-const T1 Real)
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
(assert (> T1 0))
(check-sat)
