; TH-ACTIVE, gain: the gain by the forces is d(m + 1 − 2βd − 2σ)
; not with m ticks instead of m + 1
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const n Real)
(declare-const a Real)
(declare-const m Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (- n a))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (+ n m))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (- def3 def1))
(define-fun def6 () Real (ite (>= def5 0) def5 (- def5)))
(assert (= (to_real floor2) (- n 1.0)))
(assert (= (to_real floor4) def3))
(assert (> a 0.0))
(assert (<= 0.0 m))
; what would contradict the goal
(assert (not (= (- (- (* (- (+ (to_real floor2) (/ 1.0 2))) (- def3 def1)) (* (- (+ (to_real floor4) (/ 1.0 2))) (- def3 def1))) (+ (* def6 (+ (* beta def6) sigma)) (* def6 (+ (* beta def6) sigma)))) (* (+ (- m 1.0) a) (- (+ (- m 1.0) 1.0) (+ (+ (* beta (+ (- m 1.0) a)) sigma) (+ (* beta (+ (- m 1.0) a)) sigma)))))))
(check-sat)
