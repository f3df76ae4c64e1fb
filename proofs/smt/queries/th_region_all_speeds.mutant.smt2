; TH-REGION, all speeds: where the smaller coefficient is not negative the criterion holds at every speed
; else it does not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const v Real)
(declare-const beta Real)
(declare-const sigma Real)
(assert (> v 0))
; what would contradict the goal
(assert (not (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2))))))
(check-sat)
