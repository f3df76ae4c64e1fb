; TH-JITTER, short intervals: for Δτ ≤ 1 the criterion makes the bound non-negative
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const dtau Real)
(declare-const beta Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const sigma Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(assert (> dtau 0))
(assert (<= 0 (+ (* (- beta (* (* 1 1) (+ (/ 1 2) 0))) (/ def2 dtau)) (- sigma (/ (* 1 1) 2)))))
(assert (<= dtau 1))
(check-sat)
