; TH-UNI, outside: outside it pushes with nothing, and stores nothing
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x0 Real)
(declare-const floor1 Real) ; floor of x0
(assert (and (<= floor1 x0) (< x0 (+ floor1 1))))
(assert (<= floor1 (- 1)))
(assert (<= x0 0))
(check-sat)
