; TH-ACTIVE, none where passive: where β ≥ ½ and σ ≥ ½ no cycle of m and a gains
; not where σ < ½
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const m Real)
(declare-const a Real)
(declare-const beta Real)
(declare-const sigma Real)
(assert (<= 0 m))
(assert (> a 0))
(assert (<= a 1))
(assert (<= (/ 1 2) beta))
; what would contradict the goal
(assert (not (<= (* (+ m a) (- (+ m 1) (+ (+ (* beta (+ m a)) sigma) (+ (* beta (+ m a)) sigma)))) 0)))
(check-sat)
