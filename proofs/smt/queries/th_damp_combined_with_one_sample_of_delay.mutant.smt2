; TH-DAMP, combined with one sample of delay: encoder, law, delay, damping and force steps at once: costs and storages are the sums of the parts
; the parts alone are not nothing
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const y1 Real)
(declare-const lower Real)
(declare-const upper Real)
(declare-const B Real)
(declare-const y0 Real)
(declare-const r Real)
(declare-const end Real)
(declare-const y2 Real)
(declare-const delta Real)
(declare-const floor1 Real) ; floor of y1
(assert (and (<= floor1 y1) (< y1 (+ floor1 1))))
(define-fun def2 () Real (+ floor1 (/ 1 2)))
(define-fun def3 () Real (ite (>= def2 lower) def2 lower))
(define-fun def4 () Real (ite (<= def3 upper) def3 upper))
(declare-const floor5 Real) ; floor of y0
(assert (and (<= floor5 y0) (< y0 (+ floor5 1))))
(define-fun def6 () Real (ite (>= end lower) end lower))
(define-fun def7 () Real (ite (<= def6 upper) def6 upper))
(define-fun def8 () Real (ite (>= y2 lower) y2 lower))
(define-fun def9 () Real (ite (<= def8 upper) def8 upper))
(define-fun def10 () Real (- end y2))
(define-fun def11 () Real (ite (>= def10 0) def10 (- def10)))
; what would contradict the goal
(assert (not (= (- (- (- (+ (* (+ (- (- def4) (* B (- floor1 floor5))) r) (- end y2)) (- (* end def7) (/ (* def7 def7) 2))) (- (* y2 def9) (/ (* def9 def9) 2))) (* def11 (+ (* (- (- (- 0 (* (* 1 1) (+ (/ 1 2) 1))) B)) def11) (- (- (- (- 0 (/ (* 1 1) 2)) (* B (/ 1 1))) (/ delta 2)))))) (+ (- (+ 0 (/ (* (+ 0 1) (* (- y2 y1) (- y2 y1))) 2)) (+ 0 (/ (* (+ 0 1) (* def10 def10)) 2))) (- (/ (* B (+ (+ 0 (* (- y2 y1) (- y2 y1))) (* (- y1 y0) (- y1 y0)))) 2) (/ (* B (+ (+ 0 (* def10 def10)) (* (- y2 y1) (- y2 y1)))) 2)))) 0)))
(check-sat)
