; TH-LTI, one pole step: so Dw + D²(1 − a)/(1 + a) covers what the filter's storage gains over a sample
; not by itself
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const a Real)
(declare-const w Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const share Real)
(declare-const stored Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
; what would contradict the goal
(assert (not (<= 0 (- (+ (* w (- x1 x0)) (* share (* (- x1 x0) (- x1 x0)))) stored))))
(check-sat)
