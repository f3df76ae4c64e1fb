; TH-COUNTS, counted potential: the potential where the interval ends, less what the excess does within the tick, is between the ends that the code finds
; the potential where the interval ends, less what the excess does within the tick, is between the ends that the code finds
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const y Real)
(declare-const end Real)
(declare-const f Real)
(define-fun def1 () Real (- (- end f)))
(define-fun def2 () Real (ite (>= def1 0) def1 0))
(define-fun def3 () Real (ite (<= def2 1) def2 1))
(define-fun def4 () Real (+ (- end f) (/ 1 2)))
(define-fun def5 () Real (ite (>= def4 0) def4 0))
(assert (and (<= 0 y) (<= y 1)))
; what would contradict the goal
(assert (not (and (<= (+ (/ (* end end) 2) (* def3 (+ (- end f) (/ def3 2)))) (- (/ (* (+ end y) (+ end y)) 2) (* f y))) (<= (- (/ (* (+ end y) (+ end y)) 2) (* f y)) (+ (/ (* end end) 2) def5)))))
(check-sat)
