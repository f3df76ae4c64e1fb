; EQ-27, same as 8: (27) holds of a move exactly where (8) holds at its mean speed
; (27) holds of a move exactly where (8) holds at its mean speed
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const t1 Real)
(declare-const d1 Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (ite (>= d1 0) d1 (- d1)))
(assert (> t1 0))
(assert (or (> 0 d1) (> d1 0)))
; what would contradict the goal
(assert (not (and (or (not (<= 0 (* def1 (+ (* (- beta (/ 1 2)) (/ def1 t1)) (- sigma (/ 1 2)))))) (<= (+ (/ 1 2) (/ (/ 1 2) (/ def1 t1))) (+ beta (/ sigma (/ def1 t1))))) (or (not (<= (+ (/ 1 2) (/ (/ 1 2) (/ def1 t1))) (+ beta (/ sigma (/ def1 t1))))) (<= 0 (* def1 (+ (* (- beta (/ 1 2)) (/ def1 t1)) (- sigma (/ 1 2)))))))))
(check-sat)
