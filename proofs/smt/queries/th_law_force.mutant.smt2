; TH-LAW, force: a force that is only limited is the law of the wall
; one-sided it is not that of both sides
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const q Real)
(declare-const L Real)
(define-fun def1 () Real (- 1.0))
(define-fun def2 () Real (ite (>= q def1) q def1))
(define-fun def3 () Real (ite (<= def2 0.0) def2 0.0))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (- (* (* 1.0 q) (+ (to_real floor4) 1.0))))
(define-fun def6 () Real (ite (<= def5 L) def5 L))
(define-fun def7 () Real (- L))
(define-fun def8 () Real (ite (>= def6 def7) def6 def7))
(define-fun def9 () Real (ite (>= q def7) q def7))
(define-fun def10 () Real (ite (<= def9 L) def9 L))
(assert (or (= (to_real floor4) def1) (= (to_real floor4) 0.0)))
(assert (> L 0.0))
; what would contradict the goal
(assert (not (= def8 (- def10))))
(check-sat)
