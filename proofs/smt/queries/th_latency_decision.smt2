; TH-LATENCY, decision: the two numbers of the code are not negative exactly where β ≥ κ
; the two numbers of the code are not negative exactly where β ≥ κ
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const m Real)
(declare-const Var Real)
(declare-const root Real)
(declare-const beta Real)
(assert (<= 0 m))
(assert (<= 0 Var))
(assert (<= 0 root))
(assert (= (* root root) (+ (* (+ (/ 1 2) m) (+ (/ 1 2) m)) Var)))
; what would contradict the goal
(assert (not (and (or (not (and (<= 0 (- (- beta (/ 1 2)) m)) (<= 0 (- (+ (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m))) (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m)))) Var)))) (<= (/ (+ (+ (/ 1 2) m) root) 2) beta)) (or (not (<= (/ (+ (+ (/ 1 2) m) root) 2) beta)) (and (<= 0 (- (- beta (/ 1 2)) m)) (<= 0 (- (+ (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m))) (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m)))) Var)))))))
(check-sat)
