; TH-REGION, up to a speed: the margin up to a speed is the least of the margins up to it
; the margin up to a speed is the least of the margins up to it
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const v Real)
(declare-const bound Real)
(declare-const sigma Real)
(declare-const beta Real)
(define-fun def1 () Real (- sigma (/ 1 2)))
(define-fun def2 () Real (+ (* (- beta (/ 1 2)) bound) def1))
(define-fun def3 () Real (ite (<= def1 def2) def1 def2))
(assert (> v 0))
(assert (<= v bound))
; what would contradict the goal
(assert (not (and (<= def3 (+ (* (- beta (/ 1 2)) v) def1)) (or (= def3 def2) (= def3 def1)))))
(check-sat)
