; TH-COUNTS, counted potential: the potential where the interval ends, less what the excess does within the tick, is between the ends that the code finds
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const y Real)
(assert (and (<= 0 y) (<= y 1)))
(check-sat)
