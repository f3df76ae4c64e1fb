; TH-DELAY, three samples: the step pays k·d², what was stored before pays the rest
; the step alone does not pay for it
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const d Real)
(declare-const d1 Real)
(declare-const d2 Real)
(declare-const d3 Real)
; what would contradict the goal
(assert (not (<= (* d (+ (+ (+ 0 d1) d2) d3)) (* 3 (* d d)))))
(check-sat)
