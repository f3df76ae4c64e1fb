; EQ-16/17, range: quantization adds between 0 and 1/8 to the potential
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(check-sat)
