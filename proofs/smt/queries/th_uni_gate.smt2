; TH-UNI, gate: the floor of the gate is −1 outside of the wall and 0 inside
; the floor of the gate is −1 outside of the wall and 0 inside
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status unsat)
(declare-const q Real)
(define-fun def1 () Real (- 1.0))
(define-fun def2 () Real (ite (>= q def1) q def1))
(define-fun def3 () Real (ite (<= def2 0.0) def2 0.0))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
; what would contradict the goal
(assert (not (and (or (= (to_real floor4) def1) (= (to_real floor4) 0.0)) (or (> 0.0 q) (= (to_real floor4) 0.0)) (or (<= 0.0 q) (= (to_real floor4) def1)))))
(check-sat)
