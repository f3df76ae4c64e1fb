; TH-DELAY, force: k samples late it is the force of the sample k before
; not of the one after
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const q1 Real)
(declare-const q2 Real)
(declare-const q3 Real)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(define-fun def1 () Real (- 1.0))
(define-fun def2 () Real (ite (>= q2 def1) q2 def1))
(define-fun def3 () Real (ite (<= def2 0.0) def2 0.0))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (+ (/ (* (- (* (+ (* 1.0 q2) (* (- B) (- q3 q2))) (+ (to_real floor4) 1.0))) 1.0) delta) (/ 1.0 2)))
(declare-const floor6 Int) ; floor of def5
(assert (and (<= (to_real floor6) def5) (< def5 (+ (to_real floor6) 1))))
(define-fun def7 () Real (/ (* (to_real floor6) delta) 1.0))
(define-fun def8 () Real (ite (<= def7 L) def7 L))
(define-fun def9 () Real (- L))
(define-fun def10 () Real (ite (>= def8 def9) def8 def9))
(define-fun def11 () Real (ite (>= q1 def1) q1 def1))
(define-fun def12 () Real (ite (<= def11 0.0) def11 0.0))
(declare-const floor13 Int) ; floor of def12
(assert (and (<= (to_real floor13) def12) (< def12 (+ (to_real floor13) 1))))
(define-fun def14 () Real (+ (/ (* (- (* (+ (* 1.0 q1) (* (- B) (- q2 q1))) (+ (to_real floor13) 1.0))) 1.0) delta) (/ 1.0 2)))
(declare-const floor15 Int) ; floor of def14
(assert (and (<= (to_real floor15) def14) (< def14 (+ (to_real floor15) 1))))
(define-fun def16 () Real (/ (* (to_real floor15) delta) 1.0))
(define-fun def17 () Real (ite (<= def16 L) def16 L))
(define-fun def18 () Real (ite (>= def17 def9) def17 def9))
(assert (= q1 (/ 1.0 1.0)))
(assert (= q2 (/ 2.0 1.0)))
(assert (= q3 (/ 3.0 1.0)))
(assert (= B (/ 0.0 1.0)))
(assert (= delta (/ 1.0 1.0)))
(assert (= L (/ 9.0 1.0)))
; what would contradict the goal
(assert (not (= def10 def18)))
(check-sat)
