; TH-COUNTS, counted quantized energy: generated energy between two ticks is what the closed form is of, the upper ends of the ticks included
; generated energy between two ticks is what the closed form is of, the upper ends of the ticks included
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const tick Real)
(declare-const xi0 Real)
(declare-const k Real)
(declare-const xi1 Real)
(declare-const f Real)
(declare-const F Real)
(declare-const floor1 Real) ; floor of xi0
(assert (and (<= floor1 xi0) (< xi0 (+ floor1 1))))
(declare-const floor2 Real) ; floor of xi1
(assert (and (<= floor2 xi1) (< xi1 (+ floor2 1))))
(assert (or (and (<= tick xi0) (> (+ tick 1) xi0) (= floor1 tick)) (and (= xi0 (+ tick 1)) (= floor1 (+ tick 1)))))
(assert (or (and (<= (+ tick k) xi1) (> (+ (+ tick k) 1) xi1) (= floor2 (+ tick k))) (and (= xi1 (+ (+ tick k) 1)) (= floor2 (+ (+ tick k) 1)))))
(assert (= f (+ (+ F tick) (/ 1 2))))
; what would contradict the goal
(assert (not (= (+ (* (- F (- (+ floor1 (/ 1 2)))) (- xi1 xi0)) (/ (* (- floor2 floor1) (- (+ (- floor2 floor1) (+ (- xi1 floor2) (- xi1 floor2))) 1)) 2)) (- (+ (* k (+ f (/ (- k 1) 2))) (* (+ f k) (- xi1 (+ tick k)))) (* f (- xi0 tick))))))
(check-sat)
