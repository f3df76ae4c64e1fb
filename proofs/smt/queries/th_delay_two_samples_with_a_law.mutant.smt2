; TH-DELAY, two samples with a law: behind an encoder and any law, the step pays ½|d| + k·d², what was stored the rest
; not when the force is off by more
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const g Real)
(declare-const d Real)
(declare-const d2 Real)
(declare-const d1 Real)
(define-fun def1 () Real (ite (>= d 0) d (- d)))
; what would contradict the goal
(assert (not (<= (* g d) (+ (+ (/ def1 2) (* 2 (* d d))) (- (+ (+ 0 (/ (* (+ 0 1) (* d2 d2)) 2)) (/ (* (+ (+ 0 1) 1) (* d1 d1)) 2)) (+ (+ 0 (/ (* (+ 0 1) (* d1 d1)) 2)) (/ (* (+ (+ 0 1) 1) (* d d)) 2)))))))
(check-sat)
