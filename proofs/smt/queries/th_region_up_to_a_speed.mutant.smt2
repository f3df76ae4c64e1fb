; TH-REGION, up to a speed: the margin up to a speed is the least of the margins up to it
; the margin at the bound is not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const v Real)
(declare-const bound Real)
(declare-const beta Real)
(declare-const sigma Real)
(assert (> v 0))
(assert (<= v bound))
; what would contradict the goal
(assert (not (or (<= v 0) (<= (+ (* (- beta (/ 1 2)) bound) (- sigma (/ 1 2))) (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2)))))))
(check-sat)
