; TH-COUNTS, quantized end position: within a tick, its upper end included, generated energy against the quantized spring changes by F + n + ½ a tick, up with the end and down with the start
; within a tick, its upper end included, generated energy against the quantized spring changes by F + n + ½ a tick, up with the end and down with the start
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const tick Real)
(declare-const x Real)
(declare-const F Real)
(declare-const e Real)
(declare-const floor1 Real) ; floor of tick
(assert (and (<= floor1 tick) (< tick (+ floor1 1))))
(declare-const floor2 Real) ; floor of x
(assert (and (<= floor2 x) (< x (+ floor2 1))))
(declare-const floor3 Real) ; floor of e
(assert (and (<= floor3 e) (< e (+ floor3 1))))
(assert (= floor1 tick))
(assert (or (and (<= tick x) (> (+ tick 1) x) (= floor2 tick)) (and (= x (+ tick 1)) (= floor2 (+ tick 1)))))
; what would contradict the goal
(assert (not (= (- (+ (* (- F (- (+ floor3 (/ 1 2)))) (- x e)) (/ (* (- floor2 floor3) (- (+ (- floor2 floor3) (+ (- x floor2) (- x floor2))) 1)) 2)) (+ (* (- F (- (+ floor3 (/ 1 2)))) (- tick e)) (/ (* (- floor1 floor3) (- (+ (- floor1 floor3) (+ (- tick floor1) (- tick floor1))) 1)) 2))) (* (+ (+ F tick) (/ 1 2)) (- x tick)))))
(check-sat)
