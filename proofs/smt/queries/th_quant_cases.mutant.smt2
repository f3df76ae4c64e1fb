; TH-QUANT, cases: with N = ⌊|d|⌋ the ticks crossed are N or N + 1, in the direction of d
; they are not always N
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
(define-fun def3 () Real (- (to_real floor1) (to_real floor2)))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(define-fun def5 () Real (- x1 x0))
(define-fun def6 () Real (ite (>= def5 0) def5 (- def5)))
(declare-const floor7 Int) ; floor of def6
(assert (and (<= (to_real floor7) def6) (< def6 (+ (to_real floor7) 1))))
; what would contradict the goal
(assert (not (= def4 (to_real floor7))))
(check-sat)
