; TH-COUNTS, vertex forward: where the slope changes its sign that is a value between the ends
; where the slope changes its sign that is a value between the ends
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const from Real)
(declare-const to Real)
(declare-const alpha Real)
(declare-const gamma Real)
(declare-const sigma Real)
(declare-const d Real)
(declare-const kappa Real)
(define-fun def1 () Real (ite (>= d 0) d (- d)))
(assert (<= 0 from))
(assert (<= from to))
(assert (or (> 0 alpha) (> alpha 0)))
(assert (or (and (> 0 (+ (* (+ alpha alpha) from) (+ gamma sigma))) (> (+ (* (+ alpha alpha) to) (+ gamma sigma)) 0)) (and (> (+ (* (+ alpha alpha) from) (+ gamma sigma)) 0) (> 0 (+ (* (+ alpha alpha) to) (+ gamma sigma))))))
(assert (= (* d (+ alpha alpha)) (- (+ gamma sigma))))
; what would contradict the goal
(assert (not (and (> d from) (> to d) (= (+ (+ (* d (+ (* alpha d) gamma)) (* sigma def1)) kappa) (- kappa (/ (* (+ gamma sigma) (+ gamma sigma)) (+ (+ alpha alpha) (+ alpha alpha))))))))
(check-sat)
