; TH-COUNTS, chord behind back: where friction is not negative net energy against the quantized wall is not above the chord from one corner of the two ticks to the next
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x Real)
(declare-const y Real)
(declare-const k Real)
(declare-const beta Real)
(declare-const sigma Real)
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (<= k (- 1)))
(assert (<= 0 (- (- 1 y) (- 1 x))))
(assert (<= 0 beta))
(assert (<= 0 sigma))
(check-sat)
