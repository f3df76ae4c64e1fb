; TH-COUNTS, counted potential reached: it is least where the potential's slope is the excess, and most at an end
; it is least where the potential's slope is the excess, and most at an end
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const y Real)
(declare-const f Real)
(declare-const end Real)
(define-fun def1 () Real (- f end))
(define-fun def2 () Real (ite (>= def1 0) def1 0))
(define-fun def3 () Real (ite (<= def2 1) def2 1))
(define-fun def4 () Real (- (- end f)))
(define-fun def5 () Real (ite (>= def4 0) def4 0))
(define-fun def6 () Real (ite (<= def5 1) def5 1))
(define-fun def7 () Real (+ (- end f) (/ 1 2)))
(define-fun def8 () Real (ite (>= def7 0) def7 0))
(assert (= y def3))
; what would contradict the goal
(assert (not (and (and (<= 0 y) (<= y 1)) (= (+ (/ (* end end) 2) (* def6 (+ (- end f) (/ def6 2)))) (- (/ (* (+ end y) (+ end y)) 2) (* f y))) (or (= (+ (/ (* end end) 2) def8) (- (/ (* (+ end 0) (+ end 0)) 2) (* f 0))) (= (+ (/ (* end end) 2) def8) (- (/ (* (+ end 1) (+ end 1)) 2) (* f 1)))))))
(check-sat)
