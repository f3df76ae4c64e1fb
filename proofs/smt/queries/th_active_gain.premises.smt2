; TH-ACTIVE, gain: the gain by the forces is d(m + 1 − 2βd − 2σ)
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const n Real)
(declare-const a Real)
(declare-const m Real)
(define-fun def1 () Real (- n a))
(declare-const floor2 Real) ; floor of def1
(assert (and (<= floor2 def1) (< def1 (+ floor2 1))))
(define-fun def3 () Real (+ n m))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(assert (= floor2 (- n 1)))
(assert (= floor4 def3))
(assert (> a 0))
(assert (<= 0 m))
(check-sat)
