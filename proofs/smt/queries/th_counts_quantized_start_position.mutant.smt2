; TH-COUNTS, quantized start position: within a tick, its upper end included, generated energy against the quantized spring changes by F + n + ½ a tick, up with the end and down with the start
; not across ticks
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const tick Real)
(declare-const F Real)
(declare-const e Real)
(declare-const x Real)
(declare-const floor1 Int) ; floor of tick
(assert (and (<= (to_real floor1) tick) (< tick (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x
(assert (and (<= (to_real floor2) x) (< x (+ (to_real floor2) 1))))
(declare-const floor3 Int) ; floor of e
(assert (and (<= (to_real floor3) e) (< e (+ (to_real floor3) 1))))
(assert (= (to_real floor1) tick))
(assert (= tick (/ 0.0 1.0)))
(assert (= F (/ 0.0 1.0)))
(assert (= e (/ 0.0 1.0)))
(assert (= x (/ 7.0 2.0)))
; what would contradict the goal
(assert (not (= (- (+ (* (- F (- (+ (to_real floor2) (/ 1.0 2)))) (- e x)) (/ (* (- (to_real floor3) (to_real floor2)) (- (+ (- (to_real floor3) (to_real floor2)) (+ (- e (to_real floor3)) (- e (to_real floor3)))) 1.0)) 2)) (+ (* (- F (- (+ (to_real floor1) (/ 1.0 2)))) (- e tick)) (/ (* (- (to_real floor3) (to_real floor1)) (- (+ (- (to_real floor3) (to_real floor1)) (+ (- e (to_real floor3)) (- e (to_real floor3)))) 1.0)) 2))) (- (* (+ (+ F tick) (/ 1.0 2)) (- x tick))))))
(check-sat)
