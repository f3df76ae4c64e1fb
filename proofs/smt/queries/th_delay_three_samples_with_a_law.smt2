; TH-DELAY, three samples with a law: behind an encoder and any law, the step pays ½|d| + k·d², what was stored the rest
; behind an encoder and any law, the step pays ½|d| + k·d², what was stored the rest
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const g Real)
(declare-const d1 Real)
(declare-const d2 Real)
(declare-const d3 Real)
(declare-const d Real)
(define-fun def1 () Real (ite (>= g 0) g (- g)))
(define-fun def2 () Real (+ (+ (+ 0 d1) d2) d3))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
(define-fun def4 () Real (ite (>= d 0) d (- d)))
(assert (<= def1 (+ def3 (/ 1 2))))
; what would contradict the goal
(assert (not (<= (* g d) (+ (+ (/ def4 2) (* 3 (* d d))) (- (+ (+ (+ 0 (/ (* (+ 0 1) (* d3 d3)) 2)) (/ (* (+ (+ 0 1) 1) (* d2 d2)) 2)) (/ (* (+ (+ (+ 0 1) 1) 1) (* d1 d1)) 2)) (+ (+ (+ 0 (/ (* (+ 0 1) (* d2 d2)) 2)) (/ (* (+ (+ 0 1) 1) (* d1 d1)) 2)) (/ (* (+ (+ (+ 0 1) 1) 1) (* d d)) 2)))))))
(check-sat)
