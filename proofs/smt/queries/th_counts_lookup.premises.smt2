; TH-COUNTS, lookup: under the wall's own force the row of two positions is that of the same two any whole number of ticks away
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const dtau Real)
(declare-const x Real)
(declare-const k Real)
(declare-const y Real)
(define-fun def1 () Real (+ x k))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (+ x 0.0))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (+ y k))
(declare-const floor6 Int) ; floor of def5
(assert (and (<= (to_real floor6) def5) (< def5 (+ (to_real floor6) 1))))
(define-fun def7 () Real (+ y 0.0))
(declare-const floor8 Int) ; floor of def7
(assert (and (<= (to_real floor8) def7) (< def7 (+ (to_real floor8) 1))))
(assert (> dtau 0.0))
(assert (= (to_real floor2) (+ (to_real floor4) k)))
(assert (= (to_real floor6) (+ (to_real floor8) k)))
(check-sat)
