; TH-NDOF, ticks: on ways of whole ticks a cycle gains −2dᵀ(diag(b) − (T/2)K)d/T − 2Σcᵢ|dᵢ|
; on ways of whole ticks a cycle gains −2dᵀ(diag(b) − (T/2)K)d/T − 2Σcᵢ|dᵢ|
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const T Real)
(declare-const D1 Real)
(declare-const D2 Real)
(declare-const x1 Real)
(declare-const m1 Real)
(declare-const x2 Real)
(declare-const m2 Real)
(declare-const K11 Real)
(declare-const K12 Real)
(declare-const K22 Real)
(declare-const b1 Real)
(declare-const c1 Real)
(declare-const b2 Real)
(declare-const c2 Real)
(define-fun def1 () Real (+ x1 m1))
(declare-const floor2 Real) ; floor of def1
(assert (and (<= floor2 def1) (< def1 (+ floor2 1))))
(declare-const floor3 Real) ; floor of x1
(assert (and (<= floor3 x1) (< x1 (+ floor3 1))))
(define-fun def4 () Real (+ x2 m2))
(declare-const floor5 Real) ; floor of def4
(assert (and (<= floor5 def4) (< def4 (+ floor5 1))))
(declare-const floor6 Real) ; floor of x2
(assert (and (<= floor6 x2) (< x2 (+ floor6 1))))
(define-fun def7 () Real (* D1 m1))
(define-fun def8 () Real (ite (>= def7 0) def7 (- def7)))
(define-fun def9 () Real (* D2 m2))
(define-fun def10 () Real (ite (>= def9 0) def9 (- def9)))
(assert (> T 0))
(assert (> D1 0))
(assert (> D2 0))
(assert (= floor2 (+ floor3 m1)))
(assert (= floor5 (+ floor6 m2)))
; what would contradict the goal
(assert (not (= (- (+ (+ (+ 0 (* (- (+ (+ 0 (* (* 1 K11) (* D1 (+ floor3 (/ 1 2))))) (* (* 1 K12) (* D2 (+ floor6 (/ 1 2)))))) (- (* D1 def1) (* D1 x1)))) (* (- (+ (+ 0 (* (* 1 K12) (* D1 (+ floor3 (/ 1 2))))) (* (* 1 K22) (* D2 (+ floor6 (/ 1 2)))))) (- (* D2 def4) (* D2 x2)))) (+ (+ 0 (* (- (+ (+ 0 (* (* 1 K11) (* D1 (+ floor2 (/ 1 2))))) (* (* 1 K12) (* D2 (+ floor5 (/ 1 2)))))) (- (* D1 x1) (* D1 def1)))) (* (- (+ (+ 0 (* (* 1 K12) (* D1 (+ floor2 (/ 1 2))))) (* (* 1 K22) (* D2 (+ floor5 (/ 1 2)))))) (- (* D2 x2) (* D2 def4))))) (+ (+ (+ (+ (+ 0 (/ (* b1 (* (* D1 m1) (* D1 m1))) T)) (* c1 def8)) (/ (* b2 (* (* D2 m2) (* D2 m2))) T)) (* c2 def10)) (+ (+ (+ (+ 0 (/ (* b1 (* def7 def7)) T)) (* c1 def8)) (/ (* b2 (* def9 def9)) T)) (* c2 def10)))) (* (- (+ (/ (+ (+ 0 (* (+ (+ 0 (* (- b1 (* (/ T 2) (* 1 K11))) def7)) (* (- (* (/ T 2) (* 1 K12))) def9)) def7)) (* (+ (+ 0 (* (- (* (/ T 2) (* 1 K12))) def7)) (* (- b2 (* (/ T 2) (* 1 K22))) def9)) def9)) T) (+ (+ 0 (* def8 c1)) (* def10 c2)))) 2))))
(check-sat)
