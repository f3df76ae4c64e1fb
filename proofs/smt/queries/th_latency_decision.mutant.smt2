; TH-LATENCY, decision: the two numbers of the code are not negative exactly where β ≥ κ
; the square alone is not enough
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const m Real)
(declare-const Var Real)
(declare-const root Real)
(declare-const beta Real)
(assert (<= 0 m))
(assert (<= 0 Var))
(assert (<= 0 root))
(assert (= (* root root) (+ (* (+ (/ 1 2) m) (+ (/ 1 2) m)) Var)))
; what would contradict the goal
(assert (not (and (or (not (<= 0 (- (+ (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m))) (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m)))) Var))) (<= (/ (+ (+ (/ 1 2) m) root) 2) beta)) (or (not (<= (/ (+ (+ (/ 1 2) m) root) 2) beta)) (<= 0 (- (+ (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m))) (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m)))) Var))))))
(check-sat)
