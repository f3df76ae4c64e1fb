; TH-ACTIVE, gains: where friction leaves room the cycle gains
; where friction leaves room the cycle gains
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const m Real)
(declare-const a Real)
(declare-const beta Real)
(declare-const sigma Real)
(assert (<= 0 m))
(assert (> a 0))
(assert (> (- (+ m 1) (+ (+ (* beta (+ m a)) sigma) (+ (* beta (+ m a)) sigma))) 0))
; what would contradict the goal
(assert (<= (* (+ m a) (- (+ m 1) (+ (+ (* beta (+ m a)) sigma) (+ (* beta (+ m a)) sigma)))) 0))
(check-sat)
