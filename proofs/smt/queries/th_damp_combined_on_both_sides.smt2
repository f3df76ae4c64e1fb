; TH-DAMP, combined on both sides: encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts
; encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const y0 Real)
(declare-const B Real)
(declare-const y1 Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const end Real)
(declare-const floor1 Real) ; floor of y0
(assert (and (<= floor1 y0) (< y0 (+ floor1 1))))
(declare-const floor2 Real) ; floor of y1
(assert (and (<= floor2 y1) (< y1 (+ floor2 1))))
(define-fun def3 () Real (+ (/ (* (- (+ (* 1 (+ floor1 (/ 1 2))) (* (- B) (- (+ floor2 (/ 1 2)) (+ floor1 (/ 1 2)))))) 1) delta) (/ 1 2)))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(define-fun def5 () Real (/ (* floor4 delta) 1))
(define-fun def6 () Real (ite (<= def5 L) def5 L))
(define-fun def7 () Real (- L))
(define-fun def8 () Real (ite (>= def6 def7) def6 def7))
(define-fun def9 () Real (ite (>= end def7) end def7))
(define-fun def10 () Real (ite (<= def9 L) def9 L))
(define-fun def11 () Real (ite (>= y0 def7) y0 def7))
(define-fun def12 () Real (ite (<= def11 L) def11 L))
(define-fun def13 () Real (- end y0))
(define-fun def14 () Real (ite (>= def13 0) def13 (- def13)))
(define-fun def15 () Real (+ floor1 (/ 1 2)))
(define-fun def16 () Real (ite (>= def15 def7) def15 def7))
(define-fun def17 () Real (ite (<= def16 L) def16 L))
; what would contradict the goal
(assert (not (= (- (- (- (+ (* def8 (- end y0)) (- (* end def10) (/ (* def10 def10) 2))) (- (* y0 def12) (/ (* def12 def12) 2))) (* def14 (+ (* (+ (* (* 1 1) (+ (/ 1 2) 0)) B) def14) (+ (+ (/ (* 1 1) 2) (* B (/ 1 1))) (/ delta 2))))) (+ (- 0 0) (- (/ (* B (+ 0 (* (- y0 y1) (- y0 y1)))) 2) (/ (* B (+ 0 (* def13 def13))) 2)))) (+ (+ (- (- (- (- (* end def10) (/ (* def10 def10) 2)) (- (* y0 def12) (/ (* def12 def12) 2))) (* def12 def13)) (/ (* def13 def13) 2)) (- (* (- def12 def17) def13) (+ (+ (* (/ 1 2) def14) (* 0 (* def13 def13))) (- 0 0)))) (- (* (+ def8 def17) def13) (+ (+ (+ (* B (* def13 def13)) (* B def14)) (* (/ delta 2) def14)) (- (/ (* B (+ 0 (* (- y0 y1) (- y0 y1)))) 2) (/ (* B (+ 0 (* def13 def13))) 2))))))))
(check-sat)
