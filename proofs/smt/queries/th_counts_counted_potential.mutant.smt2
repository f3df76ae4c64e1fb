; TH-COUNTS, counted potential: the potential where the interval ends, less what the excess does within the tick, is between the ends that the code finds
; it is not always the least
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
(assert (and (<= 0 y) (<= y 1)))
; what would contradict the goal
(assert (not (= (+ (/ (* end end) 2) (* def3 (+ (- end f) (/ def3 2)))) (- (/ (* (+ end y) (+ end y)) 2) (* f y)))))
(check-sat)
