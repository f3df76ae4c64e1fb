; TH-DAC, order: rounded first and limited then: the limit need not be a whole step
; the other order is another force
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(declare-const q1 Real)
(define-fun def1 () Real (+ (/ (* (- (* 1.0 q)) 1.0) delta) (/ 1.0 2)))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (/ (* (to_real floor2) delta) 1.0))
(define-fun def4 () Real (ite (<= def3 L) def3 L))
(define-fun def5 () Real (- L))
(define-fun def6 () Real (ite (>= def4 def5) def4 def5))
(define-fun def7 () Real (- (* 1.0 q)))
(define-fun def8 () Real (ite (<= def7 L) def7 L))
(define-fun def9 () Real (ite (>= def8 def5) def8 def5))
(define-fun def10 () Real (+ (/ (* (- (* 1.0 (- def9))) 1.0) delta) (/ 1.0 2)))
(declare-const floor11 Int) ; floor of def10
(assert (and (<= (to_real floor11) def10) (< def10 (+ (to_real floor11) 1))))
(assert (> delta 0.0))
(assert (> L 0.0))
(assert (= delta (/ 1.0 1.0)))
(assert (= L (/ 2.0 3.0)))
(assert (= q (/ 5.0 1.0)))
(assert (= q1 (/ 5.0 1.0)))
; what would contradict the goal
(assert (not (= def6 (/ (* (to_real floor11) delta) 1.0))))
(check-sat)
