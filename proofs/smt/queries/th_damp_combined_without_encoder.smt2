; TH-DAMP, combined without encoder: encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts
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
(define-fun def1 () Real (- 1))
(define-fun def2 () Real (ite (>= y0 def1) y0 def1))
(define-fun def3 () Real (ite (<= def2 0) def2 0))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(define-fun def5 () Real (+ (/ (* (- (* (+ (* 1 y0) (* (- B) (- y1 y0))) (+ floor4 1))) 1) delta) (/ 1 2)))
(declare-const floor6 Real) ; floor of def5
(assert (and (<= floor6 def5) (< def5 (+ floor6 1))))
(define-fun def7 () Real (/ (* floor6 delta) 1))
(define-fun def8 () Real (ite (<= def7 L) def7 L))
(define-fun def9 () Real (- L))
(define-fun def10 () Real (ite (>= def8 def9) def8 def9))
(define-fun def11 () Real (ite (>= 0 def9) 0 def9))
(define-fun def12 () Real (ite (>= end def11) end def11))
(define-fun def13 () Real (ite (<= def12 L) def12 L))
(define-fun def14 () Real (ite (>= y0 def11) y0 def11))
(define-fun def15 () Real (ite (<= def14 L) def14 L))
(define-fun def16 () Real (- end y0))
(define-fun def17 () Real (ite (>= def16 0) def16 (- def16)))
; what would contradict the goal
(assert (not (= (- (- (- (+ (* def10 (- end y0)) (- (* end def13) (/ (* def13 def13) 2))) (- (* y0 def15) (/ (* def15 def15) 2))) (* def17 (+ (* (+ (* (* 1 1) (+ (/ 1 2) 0)) B) def17) (+ 0 (/ delta 2))))) (+ (- 0 0) (- (/ (* B (+ 0 (* (- y0 y1) (- y0 y1)))) 2) (/ (* B (+ 0 (* def16 def16))) 2)))) (+ (+ (- (- (- (- (* end def13) (/ (* def13 def13) 2)) (- (* y0 def15) (/ (* def15 def15) 2))) (* def15 def16)) (/ (* def16 def16) 2)) (- (* (- def15 def15) def16) (+ (+ (* 0 def17) (* 0 (* def16 def16))) (- 0 0)))) (- (* (+ def10 def15) def16) (+ (+ (+ (* B (* def16 def16)) (* 0 def17)) (* (/ delta 2) def17)) (- (/ (* B (+ 0 (* (- y0 y1) (- y0 y1)))) 2) (/ (* B (+ 0 (* def16 def16))) 2))))))))
(check-sat)
