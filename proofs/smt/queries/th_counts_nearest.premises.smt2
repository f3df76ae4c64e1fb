; TH-COUNTS, nearest: of two positions between their ends none are nearer than the pair that the code takes
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const a Real)
(declare-const b Real)
(declare-const c Real)
(declare-const d Real)
(declare-const x Real)
(declare-const y Real)
(assert (<= a b))
(assert (<= c d))
(assert (<= a x))
(assert (<= x b))
(assert (<= c y))
(assert (<= y d))
(check-sat)
