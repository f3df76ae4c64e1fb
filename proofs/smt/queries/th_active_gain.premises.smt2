; TH-ACTIVE, gain: the gain by the forces is d(m + 1 − 2βd − 2σ)
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const n Real)
(declare-const a Real)
(declare-const m Real)
(define-fun def1 () Real (- n a))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (+ n m))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(assert (= (to_real floor2) (- n 1.0)))
(assert (= (to_real floor4) def3))
(assert (> a 0.0))
(assert (<= 0.0 m))
(check-sat)
