; TH-COUNTS, lookup: under the wall's own force the row of two positions is that of the same two any whole number of ticks away
; not a part of a tick away
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const dtau Real)
(declare-const x Real)
(declare-const y Real)
(declare-const k Real)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (+ x 0.0))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (+ x k))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (+ y 0.0))
(declare-const floor6 Int) ; floor of def5
(assert (and (<= (to_real floor6) def5) (< def5 (+ (to_real floor6) 1))))
(define-fun def7 () Real (+ y k))
(declare-const floor8 Int) ; floor of def7
(assert (and (<= (to_real floor8) def7) (< def7 (+ (to_real floor8) 1))))
(define-fun def9 () Real (- def5 def1))
(define-fun def10 () Real (ite (>= def9 0) def9 (- def9)))
(define-fun def11 () Real (- def7 def3))
(define-fun def12 () Real (ite (>= def11 0) def11 (- def11)))
(assert (> dtau 0.0))
; what would contradict the goal
(assert (not (and (= (+ (* (- (- (+ (to_real floor2) (/ 1.0 2))) (- (+ (to_real floor2) (/ 1.0 2)))) (- (+ y 0.0) def1)) (/ (* (- (+ y 0.0) def1) (- (+ (- (+ y 0.0) def1) (+ (- def1 (to_real floor2)) (- def1 (to_real floor2)))) 1.0)) 2)) (+ (* (- (- (+ (to_real floor4) (/ 1.0 2))) (- (+ (to_real floor4) (/ 1.0 2)))) (- (+ y k) def3)) (/ (* (- (+ y k) def3) (- (+ (- (+ y k) def3) (+ (- def3 (to_real floor4)) (- def3 (to_real floor4)))) 1.0)) 2))) (= (+ (* (- (- (+ (to_real floor2) (/ 1.0 2))) (- (+ (to_real floor2) (/ 1.0 2)))) (- (+ y 0.0) def1)) (/ (* (- (to_real floor6) (to_real floor2)) (- (+ (- (to_real floor6) (to_real floor2)) (+ (- def5 (to_real floor6)) (- def5 (to_real floor6)))) 1.0)) 2)) (+ (* (- (- (+ (to_real floor4) (/ 1.0 2))) (- (+ (to_real floor4) (/ 1.0 2)))) (- (+ y k) def3)) (/ (* (- (to_real floor8) (to_real floor4)) (- (+ (- (to_real floor8) (to_real floor4)) (+ (- def7 (to_real floor8)) (- def7 (to_real floor8)))) 1.0)) 2))) (= (* def10 (+ (* beta (/ def10 dtau)) sigma)) (* def12 (+ (* beta (/ def12 dtau)) sigma))) (= (- (* def10 (+ (* beta (/ def10 dtau)) sigma)) (+ (* (- (- (+ (to_real floor2) (/ 1.0 2))) (- (+ (to_real floor2) (/ 1.0 2)))) def9) (/ (* def9 (- (+ def9 (+ (- def1 (to_real floor2)) (- def1 (to_real floor2)))) 1.0)) 2))) (- (* def12 (+ (* beta (/ def12 dtau)) sigma)) (+ (* (- (- (+ (to_real floor4) (/ 1.0 2))) (- (+ (to_real floor4) (/ 1.0 2)))) def11) (/ (* def11 (- (+ def11 (+ (- def3 (to_real floor4)) (- def3 (to_real floor4)))) 1.0)) 2)))) (= (- (* def10 (+ (* beta (/ def10 dtau)) sigma)) (+ (* (- (- (+ (to_real floor2) (/ 1.0 2))) (- (+ (to_real floor2) (/ 1.0 2)))) def9) (/ (* (- (to_real floor6) (to_real floor2)) (- (+ (- (to_real floor6) (to_real floor2)) (+ (- def5 (to_real floor6)) (- def5 (to_real floor6)))) 1.0)) 2))) (- (* def12 (+ (* beta (/ def12 dtau)) sigma)) (+ (* (- (- (+ (to_real floor4) (/ 1.0 2))) (- (+ (to_real floor4) (/ 1.0 2)))) def11) (/ (* (- (to_real floor8) (to_real floor4)) (- (+ (- (to_real floor8) (to_real floor4)) (+ (- def7 (to_real floor8)) (- def7 (to_real floor8)))) 1.0)) 2)))) (= (+ (* (- beta (* (* 1.0 1.0) (+ (/ 1.0 2) 0.0))) (/ def10 dtau)) (- sigma (/ (* 1.0 1.0) 2))) (+ (* (- beta (* (* 1.0 1.0) (+ (/ 1.0 2) 0.0))) (/ def12 dtau)) (- sigma (/ (* 1.0 1.0) 2)))))))
(check-sat)
