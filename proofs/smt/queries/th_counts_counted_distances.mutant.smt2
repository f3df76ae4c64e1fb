; TH-COUNTS, counted distances: from one tick to another it is no nearer and no farther than the code says
; it may be no more than that
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x Real)
(declare-const y Real)
(declare-const k Real)
(define-fun def1 () Real (ite (>= k 0) k (- k)))
(define-fun def2 () Real (- def1 1))
(define-fun def3 () Real (ite (>= def2 0) def2 0))
(define-fun def4 () Real (- (+ k y) x))
(define-fun def5 () Real (ite (>= def4 0) def4 (- def4)))
(assert (and (<= 0 x) (<= x 1)))
(assert (and (<= 0 y) (<= y 1)))
(assert (or (<= 1 k) (= k 0) (<= k (- 1))))
; what would contradict the goal
(assert (not (or (not true) (and (<= (+ def3 1) def5) (<= def5 (+ def1 1))))))
(check-sat)
