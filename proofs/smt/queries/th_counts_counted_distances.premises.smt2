; TH-COUNTS, counted distances: from one tick to another it is no nearer and no farther than the code says
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
(assert (or (<= 1 k) (= k 0) (<= k (- 1))))
(check-sat)
