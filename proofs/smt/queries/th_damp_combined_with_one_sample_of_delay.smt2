; TH-DAMP, combined with one sample of delay: encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts
; encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const y1 Real)
(declare-const B Real)
(declare-const y2 Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const end Real)
(declare-const y0 Real)
(declare-const floor1 Real) ; floor of y1
(assert (and (<= floor1 y1) (< y1 (+ floor1 1))))
(declare-const floor2 Real) ; floor of y2
(assert (and (<= floor2 y2) (< y2 (+ floor2 1))))
(define-fun def3 () Real (+ floor1 (/ 1 2)))
(define-fun def4 () Real (- 1))
(define-fun def5 () Real (ite (>= def3 def4) def3 def4))
(define-fun def6 () Real (ite (<= def5 0) def5 0))
(declare-const floor7 Real) ; floor of def6
(assert (and (<= floor7 def6) (< def6 (+ floor7 1))))
(define-fun def8 () Real (+ (/ (* (- (* (+ (* 1 (+ floor1 (/ 1 2))) (* (- B) (- (+ floor2 (/ 1 2)) (+ floor1 (/ 1 2))))) (+ floor7 1))) 1) delta) (/ 1 2)))
(declare-const floor9 Real) ; floor of def8
(assert (and (<= floor9 def8) (< def8 (+ floor9 1))))
(define-fun def10 () Real (/ (* floor9 delta) 1))
(define-fun def11 () Real (ite (<= def10 L) def10 L))
(define-fun def12 () Real (- L))
(define-fun def13 () Real (ite (>= def11 def12) def11 def12))
(define-fun def14 () Real (ite (>= 0 def12) 0 def12))
(define-fun def15 () Real (ite (>= end def14) end def14))
(define-fun def16 () Real (ite (<= def15 L) def15 L))
(define-fun def17 () Real (ite (>= y0 def14) y0 def14))
(define-fun def18 () Real (ite (<= def17 L) def17 L))
(define-fun def19 () Real (- end y0))
(define-fun def20 () Real (ite (>= def19 0) def19 (- def19)))
(define-fun def21 () Real (ite (>= def3 def14) def3 def14))
(define-fun def22 () Real (ite (<= def21 L) def21 L))
; what would contradict the goal
(assert (not (= (- (- (- (+ (* def13 (- end y0)) (- (* end def16) (/ (* def16 def16) 2))) (- (* y0 def18) (/ (* def18 def18) 2))) (* def20 (+ (* (+ (* (* 1 1) (+ (/ 1 2) 1)) B) def20) (+ (+ (/ (* 1 1) 2) (* B (/ 1 1))) (/ delta 2))))) (+ (- (+ 0 (/ (* (+ 0 1) (* (- y0 y1) (- y0 y1))) 2)) (+ 0 (/ (* (+ 0 1) (* def19 def19)) 2))) (- (/ (* B (+ (+ 0 (* (- y0 y1) (- y0 y1))) (* (- y1 y2) (- y1 y2)))) 2) (/ (* B (+ (+ 0 (* def19 def19)) (* (- y0 y1) (- y0 y1)))) 2)))) (+ (+ (- (- (- (- (* end def16) (/ (* def16 def16) 2)) (- (* y0 def18) (/ (* def18 def18) 2))) (* def18 def19)) (/ (* def19 def19) 2)) (- (* (- def18 def22) def19) (+ (+ (* (/ 1 2) def20) (* 1 (* def19 def19))) (- (+ 0 (/ (* (+ 0 1) (* (- y0 y1) (- y0 y1))) 2)) (+ 0 (/ (* (+ 0 1) (* def19 def19)) 2)))))) (- (* (+ def13 def22) def19) (+ (+ (+ (* B (* def19 def19)) (* B def20)) (* (/ delta 2) def20)) (- (/ (* B (+ (+ 0 (* (- y0 y1) (- y0 y1))) (* (- y1 y2) (- y1 y2)))) 2) (/ (* B (+ (+ 0 (* def19 def19)) (* (- y0 y1) (- y0 y1)))) 2))))))))
(check-sat)
