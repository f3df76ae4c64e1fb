; TH-COUNTS, least quantized net back: for each displacement net energy is within the parabola that the code takes the extremes of, and on it where a position is at an end of its tick
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x Real)
(declare-const y Real)
(declare-const k Real)
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (<= k (- 1)))
(check-sat)
