; TH-NDOF, generated: what two joints generate is ½dᵀKd + Σ dᵢKᵢⱼΔⱼ(ρⱼ − ½)
; it is not one more
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const K11 Real)
(declare-const D1 Real)
(declare-const x1 Real)
(declare-const K12 Real)
(declare-const D2 Real)
(declare-const x2 Real)
(declare-const y1 Real)
(declare-const K22 Real)
(declare-const y2 Real)
(declare-const floor1 Int) ; floor of x1
(assert (and (<= (to_real floor1) x1) (< x1 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x2
(assert (and (<= (to_real floor2) x2) (< x2 (+ (to_real floor2) 1))))
; what would contradict the goal
(assert (not (= (- (+ (+ (+ 0.0 (* (- (+ (+ 0.0 (* (* 1.0 K11) (* D1 (+ (to_real floor1) (/ 1.0 2))))) (* (* 1.0 K12) (* D2 (+ (to_real floor2) (/ 1.0 2)))))) (- (* D1 y1) (* D1 x1)))) (* (- (+ (+ 0.0 (* (* 1.0 K12) (* D1 (+ (to_real floor1) (/ 1.0 2))))) (* (* 1.0 K22) (* D2 (+ (to_real floor2) (/ 1.0 2)))))) (- (* D2 y2) (* D2 x2)))) (/ (+ (+ 0.0 (* (+ (+ 0.0 (* (* 1.0 K11) (* D1 y1))) (* (* 1.0 K12) (* D2 y2))) (* D1 y1))) (* (+ (+ 0.0 (* (* 1.0 K12) (* D1 y1))) (* (* 1.0 K22) (* D2 y2))) (* D2 y2))) 2)) (/ (+ (+ 0.0 (* (+ (+ 0.0 (* (* 1.0 K11) (* D1 x1))) (* (* 1.0 K12) (* D2 x2))) (* D1 x1))) (* (+ (+ 0.0 (* (* 1.0 K12) (* D1 x1))) (* (* 1.0 K22) (* D2 x2))) (* D2 x2))) 2)) (+ (+ (/ (+ (+ 0.0 (* (+ (+ 0.0 (* (* 1.0 K11) (* D1 (- y1 x1)))) (* (* 1.0 K12) (* D2 (- y2 x2)))) (* D1 (- y1 x1)))) (* (+ (+ 0.0 (* (* 1.0 K12) (* D1 (- y1 x1)))) (* (* 1.0 K22) (* D2 (- y2 x2)))) (* D2 (- y2 x2)))) 2) (+ (+ 0.0 (* (* D1 (- y1 x1)) (+ (+ 0.0 (* (* 1.0 K11) (* D1 (- x1 (+ (to_real floor1) (/ 1.0 2)))))) (* (* 1.0 K12) (* D2 (- x2 (+ (to_real floor2) (/ 1.0 2)))))))) (* (* D2 (- y2 x2)) (+ (+ 0.0 (* (* 1.0 K12) (* D1 (- x1 (+ (to_real floor1) (/ 1.0 2)))))) (* (* 1.0 K22) (* D2 (- x2 (+ (to_real floor2) (/ 1.0 2))))))))) 1.0))))
(check-sat)
