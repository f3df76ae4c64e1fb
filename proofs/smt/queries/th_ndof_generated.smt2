; TH-NDOF, generated: what two joints generate is ½dᵀKd + Σ dᵢKᵢⱼΔⱼ(ρⱼ − ½)
; what two joints generate is ½dᵀKd + Σ dᵢKᵢⱼΔⱼ(ρⱼ − ½)
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const K11 Real)
(declare-const D1 Real)
(declare-const x1 Real)
(declare-const K12 Real)
(declare-const D2 Real)
(declare-const x2 Real)
(declare-const y1 Real)
(declare-const K22 Real)
(declare-const y2 Real)
(declare-const floor1 Real) ; floor of x1
(assert (and (<= floor1 x1) (< x1 (+ floor1 1))))
(declare-const floor2 Real) ; floor of x2
(assert (and (<= floor2 x2) (< x2 (+ floor2 1))))
; what would contradict the goal
(assert (not (= (- (+ (+ (+ 0 (* (- (+ (+ 0 (* (* 1 K11) (* D1 (+ floor1 (/ 1 2))))) (* (* 1 K12) (* D2 (+ floor2 (/ 1 2)))))) (- (* D1 y1) (* D1 x1)))) (* (- (+ (+ 0 (* (* 1 K12) (* D1 (+ floor1 (/ 1 2))))) (* (* 1 K22) (* D2 (+ floor2 (/ 1 2)))))) (- (* D2 y2) (* D2 x2)))) (/ (+ (+ 0 (* (+ (+ 0 (* (* 1 K11) (* D1 y1))) (* (* 1 K12) (* D2 y2))) (* D1 y1))) (* (+ (+ 0 (* (* 1 K12) (* D1 y1))) (* (* 1 K22) (* D2 y2))) (* D2 y2))) 2)) (/ (+ (+ 0 (* (+ (+ 0 (* (* 1 K11) (* D1 x1))) (* (* 1 K12) (* D2 x2))) (* D1 x1))) (* (+ (+ 0 (* (* 1 K12) (* D1 x1))) (* (* 1 K22) (* D2 x2))) (* D2 x2))) 2)) (+ (/ (+ (+ 0 (* (+ (+ 0 (* (* 1 K11) (* D1 (- y1 x1)))) (* (* 1 K12) (* D2 (- y2 x2)))) (* D1 (- y1 x1)))) (* (+ (+ 0 (* (* 1 K12) (* D1 (- y1 x1)))) (* (* 1 K22) (* D2 (- y2 x2)))) (* D2 (- y2 x2)))) 2) (+ (+ 0 (* (* D1 (- y1 x1)) (+ (+ 0 (* (* 1 K11) (* D1 (- x1 (+ floor1 (/ 1 2)))))) (* (* 1 K12) (* D2 (- x2 (+ floor2 (/ 1 2)))))))) (* (* D2 (- y2 x2)) (+ (+ 0 (* (* 1 K12) (* D1 (- x1 (+ floor1 (/ 1 2)))))) (* (* 1 K22) (* D2 (- x2 (+ floor2 (/ 1 2))))))))))))
(check-sat)
