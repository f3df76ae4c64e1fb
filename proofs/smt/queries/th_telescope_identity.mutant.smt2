; TH-TELESCOPE, identity: E_g − E_gᴸ is the change of ½ρ(1 − ρ)
; it is not nothing
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const floor1 Real) ; floor of x1
(assert (and (<= floor1 x1) (< x1 (+ floor1 1))))
(declare-const floor2 Real) ; floor of x0
(assert (and (<= floor2 x0) (< x0 (+ floor2 1))))
; what would contradict the goal
(assert (not (= (- (/ (* (- floor1 floor2) (- (+ (- floor1 floor2) (+ (- x1 floor1) (- x1 floor1))) 1)) 2) (/ (* (- x1 x0) (- (+ (- x1 x0) (+ (- x0 floor2) (- x0 floor2))) 1)) 2)) 0)))
(check-sat)
