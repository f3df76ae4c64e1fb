; TH-SMOOTH, criterion: without an encoder the ½ of quantization goes
; with one it stays
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const sigma Real)
; what would contradict the goal
(assert (not (= (- sigma (/ (* 1 1) 2)) sigma)))
(check-sat)
