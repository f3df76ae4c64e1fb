; TH-COUNTS, line: on a line of equal displacement net energy is between its values at any two points around
; on a line of equal displacement net energy is between its values at any two points around
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
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
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(define-fun def5 () Real (- (+ y 0) (+ x 0)))
(define-fun def6 () Real (ite (>= def5 0) def5 (- def5)))
(define-fun def7 () Real (+ x 0))
(declare-const floor8 Real) ; floor of def7
(assert (and (<= floor8 def7) (< def7 (+ floor8 1))))
(define-fun def9 () Real (- (+ y ahead) (+ x ahead)))
(define-fun def10 () Real (ite (>= def9 0) def9 (- def9)))
(define-fun def11 () Real (+ x ahead))
(declare-const floor12 Real) ; floor of def11
(assert (and (<= floor12 def11) (< def11 (+ floor12 1))))
(assert (> dtau 0))
(assert (<= back 0))
(assert (<= 0 ahead))
; what would contradict the goal
(assert (not (or (and (<= (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (+ (* (- F (- (+ floor4 (/ 1 2)))) def1) (/ (* def1 (- (+ def1 (+ (- def3 floor4) (- def3 floor4))) 1)) 2))) (- (* def6 (+ (* beta (/ def6 dtau)) sigma)) (+ (* (- F (- (+ floor8 (/ 1 2)))) def5) (/ (* def5 (- (+ def5 (+ (- def7 floor8) (- def7 floor8))) 1)) 2)))) (<= (- (* def6 (+ (* beta (/ def6 dtau)) sigma)) (+ (* (- F (- (+ floor8 (/ 1 2)))) def5) (/ (* def5 (- (+ def5 (+ (- def7 floor8) (- def7 floor8))) 1)) 2))) (- (* def10 (+ (* beta (/ def10 dtau)) sigma)) (+ (* (- F (- (+ floor12 (/ 1 2)))) def9) (/ (* def9 (- (+ def9 (+ (- def11 floor12) (- def11 floor12))) 1)) 2))))) (and (<= (- (* def10 (+ (* beta (/ def10 dtau)) sigma)) (+ (* (- F (- (+ floor12 (/ 1 2)))) def9) (/ (* def9 (- (+ def9 (+ (- def11 floor12) (- def11 floor12))) 1)) 2))) (- (* def6 (+ (* beta (/ def6 dtau)) sigma)) (+ (* (- F (- (+ floor8 (/ 1 2)))) def5) (/ (* def5 (- (+ def5 (+ (- def7 floor8) (- def7 floor8))) 1)) 2)))) (<= (- (* def6 (+ (* beta (/ def6 dtau)) sigma)) (+ (* (- F (- (+ floor8 (/ 1 2)))) def5) (/ (* def5 (- (+ def5 (+ (- def7 floor8) (- def7 floor8))) 1)) 2))) (- (* def2 (+ (* beta (/ def2 dtau)) sigma)) (+ (* (- F (- (+ floor4 (/ 1 2)))) def1) (/ (* def1 (- (+ def1 (+ (- def3 floor4) (- def3 floor4))) 1)) 2))))))))
(check-sat)
