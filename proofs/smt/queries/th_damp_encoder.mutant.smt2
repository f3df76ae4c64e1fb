; TH-DAMP, encoder: the ticks between two samples differ from the way by less than one
; not by less than ½
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Int) ; floor of x1
(assert (and (<= (to_real floor1) x1) (< x1 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x0
(assert (and (<= (to_real floor2) x0) (< x0 (+ (to_real floor2) 1))))
(define-fun def3 () Real (- (- (to_real floor1) (to_real floor2)) (- x1 x0)))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
; what would contradict the goal
(assert (<= (/ 1.0 2) def4))
(check-sat)
