; TH-LTI, one pole stable: one pole is stable in the code exactly where its root is inside the unit circle
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const d0 Real)
(declare-const x Real)
(declare-const d1 Real)
(assert (or (> 0 d0) (> d0 0)))
(assert (= (+ (* d0 x) d1) 0))
(check-sat)
