; TH-LATENCY, squares: the two numbers are not negative exactly where 2β ≥ ½ + m and (2β − ½ − m)² ≥ (½ + m)² + Var
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const m Real)
(declare-const Var Real)
(assert (<= 0 m))
(assert (<= 0 Var))
(check-sat)
