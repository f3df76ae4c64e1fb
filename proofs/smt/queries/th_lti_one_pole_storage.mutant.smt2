; TH-LTI, one pole storage: what the storage w²/(2(1 − a)) of the filter gains over a sample is a polynomial
; not with another storage
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const a Real)
(declare-const stored Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const w Real)
(assert (<= 0 B))
(assert (<= 0 a))
(assert (> 1 a))
; what would contradict the goal
(assert (not (= stored (+ (/ (- (* (- 1 a) (* (- x1 x0) (- x1 x0))) (* (+ 1 a) (* w w))) 2) (* (* a w) (- x1 x0))))))
(check-sat)
