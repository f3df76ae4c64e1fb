; TH-COUNTS, line: on a line of equal displacement net energy is between its values at any two points around
; it is not the same everywhere
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const dtau Real)
(declare-const back Real)
(declare-const ahead Real)
(declare-const y Real)
(declare-const x Real)
(declare-const beta Real)
(declare-const sigma Real)
(declare-const F Real)
(define-fun def1 () Real (- (+ y back) (+ x back)))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(define-fun def3 () Real (+ x back))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (- (+ y 0.0) (+ x 0.0)))
(define-fun def6 () Real (ite (>= def5 0) def5 (- def5)))
(define-fun def7 () Real (+ x 0.0))
(declare-const floor8 Int) ; floor of def7
(assert (and (<= (to_real floor8) def7) (< def7 (+ (to_real floor8) 1))))
(assert (> dtau 0.0))
(assert (<= back 0.0))
(assert (<= 0.0 ahead))
; what would contradict the goal
(assert (not (= (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (+ (* (- F (- (+ (to_real floor4) (/ 1.0 2)))) def1) (/ (* def1 (- (+ def1 (+ (- def3 (to_real floor4)) (- def3 (to_real floor4)))) 1.0)) 2))) (- (* def6 (+ (* beta (/ def6 dtau)) sigma)) (+ (* (- F (- (+ (to_real floor8) (/ 1.0 2)))) def5) (/ (* def5 (- (+ def5 (+ (- def7 (to_real floor8)) (- def7 (to_real floor8)))) 1.0)) 2))))))
(check-sat)
