; TH-COUNTS, arc turn: where it turns is between the ends
; where it turns is between the ends
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const from Real)
(declare-const to Real)
(declare-const gamma Real)
(declare-const T Real)
(declare-const alpha Real)
(declare-const kappa Real)
(define-fun def1 () Real (- (* gamma T)))
(define-fun def2 () Real (ite (>= def1 from) def1 from))
(define-fun def3 () Real (ite (<= def2 to) def2 to))
(assert (<= from to))
; what would contradict the goal
(assert (not (and (and (<= from def3) (<= def3 to)) (= (+ (* def3 (+ (* alpha def3) gamma)) kappa) (+ (* def3 (+ (* alpha def3) gamma)) kappa)))))
(check-sat)
