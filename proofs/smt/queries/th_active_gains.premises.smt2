; TH-ACTIVE, gains: where friction leaves room the cycle gains
; the premises can be met
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
(assert (> (- (+ m 1) (+ (+ (* beta (+ m a)) sigma) (+ (* beta (+ m a)) sigma))) 0))
(check-sat)
