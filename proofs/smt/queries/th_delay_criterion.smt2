; TH-DELAY, criterion: the costs of the effects add
; the costs of the effects add
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const B Real)
(declare-const delta Real)
(declare-const d Real)
(define-fun def1 () Real (ite (>= d 0) d (- d)))
; what would contradict the goal
(assert (not (and (= (+ (* (* 1 1) (+ (/ 1 2) 3)) B) (+ (+ (/ 1 2) 3) B)) (= (+ (+ (/ (* 1 1) 2) (* B (/ 1 1))) (/ delta 2)) (+ (/ (+ 1 delta) 2) B)) (= (* def1 (+ (* (+ (* (* 1 1) (+ (/ 1 2) 3)) B) def1) (+ (+ (/ (* 1 1) 2) (* B (/ 1 1))) (/ delta 2)))) (+ (* (+ (+ (/ 1 2) 3) B) (* d d)) (* (+ (/ (+ 1 delta) 2) B) def1))))))
(check-sat)
