; TH-DELAY, force: k samples late it is the force of the sample k before
; k samples late it is the force of the sample k before
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const q0 Real)
(declare-const B Real)
(declare-const q1 Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const q2 Real)
(declare-const q3 Real)
(declare-const q4 Real)
(define-fun def1 () Real (- 1))
(define-fun def2 () Real (ite (>= q0 def1) q0 def1))
(define-fun def3 () Real (ite (<= def2 0) def2 0))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(define-fun def5 () Real (+ (/ (* (- (* (+ (* 1 q0) (* (- B) (- q1 q0))) (+ floor4 1))) 1) delta) (/ 1 2)))
(declare-const floor6 Real) ; floor of def5
(assert (and (<= floor6 def5) (< def5 (+ floor6 1))))
(define-fun def7 () Real (/ (* floor6 delta) 1))
(define-fun def8 () Real (ite (<= def7 L) def7 L))
(define-fun def9 () Real (- L))
(define-fun def10 () Real (ite (>= def8 def9) def8 def9))
(define-fun def11 () Real (ite (>= q1 def1) q1 def1))
(define-fun def12 () Real (ite (<= def11 0) def11 0))
(declare-const floor13 Real) ; floor of def12
(assert (and (<= floor13 def12) (< def12 (+ floor13 1))))
(define-fun def14 () Real (+ (/ (* (- (* (+ (* 1 q1) (* (- B) (- q2 q1))) (+ floor13 1))) 1) delta) (/ 1 2)))
(declare-const floor15 Real) ; floor of def14
(assert (and (<= floor15 def14) (< def14 (+ floor15 1))))
(define-fun def16 () Real (/ (* floor15 delta) 1))
(define-fun def17 () Real (ite (<= def16 L) def16 L))
(define-fun def18 () Real (ite (>= def17 def9) def17 def9))
(define-fun def19 () Real (ite (>= q2 def1) q2 def1))
(define-fun def20 () Real (ite (<= def19 0) def19 0))
(declare-const floor21 Real) ; floor of def20
(assert (and (<= floor21 def20) (< def20 (+ floor21 1))))
(define-fun def22 () Real (+ (/ (* (- (* (+ (* 1 q2) (* (- B) (- q3 q2))) (+ floor21 1))) 1) delta) (/ 1 2)))
(declare-const floor23 Real) ; floor of def22
(assert (and (<= floor23 def22) (< def22 (+ floor23 1))))
(define-fun def24 () Real (/ (* floor23 delta) 1))
(define-fun def25 () Real (ite (<= def24 L) def24 L))
(define-fun def26 () Real (ite (>= def25 def9) def25 def9))
(define-fun def27 () Real (ite (>= q3 def1) q3 def1))
(define-fun def28 () Real (ite (<= def27 0) def27 0))
(declare-const floor29 Real) ; floor of def28
(assert (and (<= floor29 def28) (< def28 (+ floor29 1))))
(define-fun def30 () Real (+ (/ (* (- (* (+ (* 1 q3) (* (- B) (- q4 q3))) (+ floor29 1))) 1) delta) (/ 1 2)))
(declare-const floor31 Real) ; floor of def30
(assert (and (<= floor31 def30) (< def30 (+ floor31 1))))
(define-fun def32 () Real (/ (* floor31 delta) 1))
(define-fun def33 () Real (ite (<= def32 L) def32 L))
(define-fun def34 () Real (ite (>= def33 def9) def33 def9))
; what would contradict the goal
(assert (not (and (= def10 def10) (= def18 def18) (= def26 def26) (= def34 def34))))
(check-sat)
