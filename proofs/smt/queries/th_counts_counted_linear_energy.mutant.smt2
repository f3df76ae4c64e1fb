; TH-COUNTS, counted linear energy: generated energy between two ticks is what the closed form is of, the upper ends of the ticks included
; not with any other excess
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const tick Real)
(declare-const xi0 Real)
(declare-const k Real)
(declare-const xi1 Real)
(declare-const F Real)
(declare-const f Real)
(declare-const floor1 Int) ; floor of xi0
(assert (and (<= (to_real floor1) xi0) (< xi0 (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of xi1
(assert (and (<= (to_real floor2) xi1) (< xi1 (+ (to_real floor2) 1))))
(assert (or (and (<= tick xi0) (> (+ tick 1.0) xi0) (= (to_real floor1) tick)) (and (= xi0 (+ tick 1.0)) (= (to_real floor1) (+ tick 1.0)))))
(assert (or (and (<= (+ tick k) xi1) (> (+ (+ tick k) 1.0) xi1) (= (to_real floor2) (+ tick k))) (and (= xi1 (+ (+ tick k) 1.0)) (= (to_real floor2) (+ (+ tick k) 1.0)))))
; what would contradict the goal
(assert (not (= (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- xi1 xi0)) (/ (* (- xi1 xi0) (- (+ (- xi1 xi0) (+ (- xi0 (to_real floor1)) (- xi0 (to_real floor1)))) 1.0)) 2)) (- (* (+ k (- xi1 (+ tick k))) (+ f (/ (- (+ k (- xi1 (+ tick k))) 1.0) 2))) (* (- xi0 tick) (+ f (/ (- (- xi0 tick) 1.0) 2)))))))
(check-sat)
