; TH-DAMP, combined on both sides: encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts
; the parts alone are not nothing
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const delta Real)
(declare-const L Real)
(declare-const B Real)
(declare-const y0 Real)
(declare-const y1 Real)
(declare-const end Real)
(declare-const floor1 Int) ; floor of y0
(assert (and (<= (to_real floor1) y0) (< y0 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of y1
(assert (and (<= (to_real floor2) y1) (< y1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (+ (/ (* (- (+ (* 1.0 (+ (to_real floor1) (/ 1.0 2))) (* (- B) (- (+ (to_real floor2) (/ 1.0 2)) (+ (to_real floor1) (/ 1.0 2)))))) 1.0) delta) (/ 1.0 2)))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (/ (* (to_real floor4) delta) 1.0))
(define-fun def6 () Real (ite (<= def5 L) def5 L))
(define-fun def7 () Real (- L))
(define-fun def8 () Real (ite (>= def6 def7) def6 def7))
(define-fun def9 () Real (ite (>= end def7) end def7))
(define-fun def10 () Real (ite (<= def9 L) def9 L))
(define-fun def11 () Real (ite (>= y0 def7) y0 def7))
(define-fun def12 () Real (ite (<= def11 L) def11 L))
(define-fun def13 () Real (- end y0))
(define-fun def14 () Real (ite (>= def13 0) def13 (- def13)))
(assert (= delta (/ 1.0 1.0)))
(assert (= L (/ 9.0 1.0)))
(assert (= B (/ 1.0 1.0)))
(assert (= y0 (/ 1.0 1.0)))
(assert (= y1 (/ 2.0 1.0)))
(assert (= end (/ 3.0 1.0)))
; what would contradict the goal
(assert (not (= (- (- (- (+ (* def8 (- end y0)) (- (* end def10) (/ (* def10 def10) 2))) (- (* y0 def12) (/ (* def12 def12) 2))) (* def14 (+ (* (+ (* (* 1.0 1.0) (+ (/ 1.0 2) 0.0)) B) def14) (+ (+ (/ (* 1.0 1.0) 2) (* B (/ 1.0 1.0))) (/ delta 2))))) (+ (- 0.0 0.0) (- (/ (* B (+ 0.0 (* (- y0 y1) (- y0 y1)))) 2) (/ (* B (+ 0.0 (* def13 def13))) 2)))) 0.0)))
(check-sat)
