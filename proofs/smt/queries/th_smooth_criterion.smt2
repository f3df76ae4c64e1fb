; TH-SMOOTH, criterion: without an encoder the ½ of quantization goes
; without an encoder the ½ of quantization goes
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const beta Real)
(declare-const sigma Real)
; what would contradict the goal
(assert (not (and (= (- beta (* (* 1 1) (+ (/ 1 2) 0))) (- beta (/ 1 2))) (= (- sigma 0) sigma))))
(check-sat)
