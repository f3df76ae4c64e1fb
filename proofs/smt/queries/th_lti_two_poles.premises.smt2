; TH-LTI, two poles: two poles are stable in the code exactly where |d₂| < |d₀| and |d₁| < |d₀ + d₂|
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const d0 Real)
(assert (or (> 0 d0) (> d0 0)))
(check-sat)
