; TH-COUNTS, counted potential reached: it is least where the potential's slope is the excess, and most at an end
; elsewhere it is not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const y Real)
(declare-const end Real)
(declare-const f Real)
(define-fun def1 () Real (- (- end f)))
(define-fun def2 () Real (ite (>= def1 0) def1 0))
(define-fun def3 () Real (ite (<= def2 1) def2 1))
(define-fun def4 () Real (+ (- end f) (/ 1 2)))
(define-fun def5 () Real (ite (>= def4 0) def4 0))
; what would contradict the goal
(assert (not (and (and (<= 0 y) (<= y 1)) (= (+ (/ (* end end) 2) (* def3 (+ (- end f) (/ def3 2)))) (- (/ (* (+ end y) (+ end y)) 2) (* f y))) (or (= (+ (/ (* end end) 2) def5) (- (/ (* (+ end 0) (+ end 0)) 2) (* f 0))) (= (+ (/ (* end end) 2) def5) (- (/ (* (+ end 1) (+ end 1)) 2) (* f 1)))))))
(check-sat)
