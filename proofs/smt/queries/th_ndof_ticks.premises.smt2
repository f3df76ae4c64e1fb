; TH-NDOF, ticks: on ways of whole ticks a cycle gains −2dᵀ(diag(b) − (T/2)K)d/T − 2Σcᵢ|dᵢ|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const T Real)
(declare-const D1 Real)
(declare-const D2 Real)
(declare-const x1 Real)
(declare-const m1 Real)
(declare-const x2 Real)
(declare-const m2 Real)
(define-fun def1 () Real (+ x1 m1))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(declare-const floor3 Int) ; floor of x1
(assert (and (<= (to_real floor3) x1) (< x1 (+ (to_real floor3) 1))))
(define-fun def4 () Real (+ x2 m2))
(declare-const floor5 Int) ; floor of def4
(assert (and (<= (to_real floor5) def4) (< def4 (+ (to_real floor5) 1))))
(declare-const floor6 Int) ; floor of x2
(assert (and (<= (to_real floor6) x2) (< x2 (+ (to_real floor6) 1))))
(assert (> T 0.0))
(assert (> D1 0.0))
(assert (> D2 0.0))
(assert (= (to_real floor2) (+ (to_real floor3) m1)))
(assert (= (to_real floor5) (+ (to_real floor6) m2)))
(check-sat)
