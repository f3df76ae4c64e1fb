; TH-COUNTS, arc turn: where it turns is between the ends
; it is not always at the start
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
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
(assert (not (= (+ (* def3 (+ (* alpha def3) gamma)) kappa) (+ (* from (+ (* alpha from) gamma)) kappa))))
(check-sat)
