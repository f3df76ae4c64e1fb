; TH-DELAY, two samples: the step pays k·d², what was stored before pays the rest
; the step pays k·d², what was stored before pays the rest
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const d Real)
(declare-const d1 Real)
(declare-const d2 Real)
; what would contradict the goal
(assert (not (<= (* d (+ (+ 0 d1) d2)) (+ (* 2 (* d d)) (- (+ (+ 0 (/ (* (+ 0 1) (* d2 d2)) 2)) (/ (* (+ (+ 0 1) 1) (* d1 d1)) 2)) (+ (+ 0 (/ (* (+ 0 1) (* d1 d1)) 2)) (/ (* (+ (+ 0 1) 1) (* d d)) 2)))))))
(check-sat)
