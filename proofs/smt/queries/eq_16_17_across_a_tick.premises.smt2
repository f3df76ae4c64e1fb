; EQ-16/17, across a tick: from inside a tick to its upper end the potential rises by the held force times the way
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(declare-const floor2 Real) ; floor of x1
(assert (and (<= floor2 x1) (< x1 (+ floor2 1))))
(assert (= x1 (+ floor1 1)))
(assert (= floor2 x1))
(check-sat)
