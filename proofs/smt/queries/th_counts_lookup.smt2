; TH-COUNTS, lookup: under the wall's own force the row of two positions is that of the same two any whole number of ticks away
; under the wall's own force the row of two positions is that of the same two any whole number of ticks away
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const dtau Real)
(declare-const x Real)
(declare-const k Real)
(declare-const y Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (+ x k))
(declare-const floor2 Real) ; floor of def1
(assert (and (<= floor2 def1) (< def1 (+ floor2 1))))
(define-fun def3 () Real (+ x 0))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(define-fun def5 () Real (+ y k))
(declare-const floor6 Real) ; floor of def5
(assert (and (<= floor6 def5) (< def5 (+ floor6 1))))
(define-fun def7 () Real (+ y 0))
(declare-const floor8 Real) ; floor of def7
(assert (and (<= floor8 def7) (< def7 (+ floor8 1))))
(define-fun def9 () Real (- def7 def3))
(define-fun def10 () Real (ite (>= def9 0) def9 (- def9)))
(define-fun def11 () Real (- def5 def1))
(define-fun def12 () Real (ite (>= def11 0) def11 (- def11)))
(assert (> dtau 0))
(assert (= floor2 (+ floor4 k)))
(assert (= floor6 (+ floor8 k)))
; what would contradict the goal
(assert (not (and (= (+ (* (- (- (+ floor4 (/ 1 2))) (- (+ floor4 (/ 1 2)))) (- def7 def3)) (/ (* (- def7 def3) (- (+ (- def7 def3) (+ (- def3 floor4) (- def3 floor4))) 1)) 2)) (+ (* (- (- (+ floor2 (/ 1 2))) (- (+ floor2 (/ 1 2)))) (- def5 def1)) (/ (* (- def5 def1) (- (+ (- def5 def1) (+ (- def1 floor2) (- def1 floor2))) 1)) 2))) (= (+ (* (- (- (+ floor4 (/ 1 2))) (- (+ floor4 (/ 1 2)))) (- def7 def3)) (/ (* (- floor8 floor4) (- (+ (- floor8 floor4) (+ (- def7 floor8) (- def7 floor8))) 1)) 2)) (+ (* (- (- (+ floor2 (/ 1 2))) (- (+ floor2 (/ 1 2)))) (- def5 def1)) (/ (* (- floor6 floor2) (- (+ (- floor6 floor2) (+ (- def5 floor6) (- def5 floor6))) 1)) 2))) (= (* def10 (+ (* beta (/ def10 dtau)) sigma)) (* def12 (+ (* beta (/ def12 dtau)) sigma))) (= (- (* def10 (+ (* beta (/ def10 dtau)) sigma)) (+ (* (- (- (+ floor4 (/ 1 2))) (- (+ floor4 (/ 1 2)))) def9) (/ (* def9 (- (+ def9 (+ (- def3 floor4) (- def3 floor4))) 1)) 2))) (- (* def12 (+ (* beta (/ def12 dtau)) sigma)) (+ (* (- (- (+ floor2 (/ 1 2))) (- (+ floor2 (/ 1 2)))) def11) (/ (* def11 (- (+ def11 (+ (- def1 floor2) (- def1 floor2))) 1)) 2)))) (= (- (* def10 (+ (* beta (/ def10 dtau)) sigma)) (+ (* (- (- (+ floor4 (/ 1 2))) (- (+ floor4 (/ 1 2)))) def9) (/ (* (- floor8 floor4) (- (+ (- floor8 floor4) (+ (- def7 floor8) (- def7 floor8))) 1)) 2))) (- (* def12 (+ (* beta (/ def12 dtau)) sigma)) (+ (* (- (- (+ floor2 (/ 1 2))) (- (+ floor2 (/ 1 2)))) def11) (/ (* (- floor6 floor2) (- (+ (- floor6 floor2) (+ (- def5 floor6) (- def5 floor6))) 1)) 2)))) (= (+ (* (- beta (* (* 1 1) (+ (/ 1 2) 0))) (/ def10 dtau)) (- sigma (/ (* 1 1) 2))) (+ (* (- beta (* (* 1 1) (+ (/ 1 2) 0))) (/ def12 dtau)) (- sigma (/ (* 1 1) 2)))))))
(check-sat)
