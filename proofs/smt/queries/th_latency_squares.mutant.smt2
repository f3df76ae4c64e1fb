; TH-LATENCY, squares: the two numbers are not negative exactly where 2β ≥ ½ + m and (2β − ½ − m)² ≥ (½ + m)² + Var
; not with the square alone
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const m Real)
(declare-const Var Real)
(declare-const beta Real)
(assert (<= 0 m))
(assert (<= 0 Var))
; what would contradict the goal
(assert (not (and (or (not (and (<= 0 (- (- beta (/ 1 2)) m)) (<= 0 (- (+ (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m))) (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m)))) Var)))) (<= (+ (* (+ (/ 1 2) m) (+ (/ 1 2) m)) Var) (* (- (+ beta beta) (+ (/ 1 2) m)) (- (+ beta beta) (+ (/ 1 2) m))))) (or (not (<= (+ (* (+ (/ 1 2) m) (+ (/ 1 2) m)) Var) (* (- (+ beta beta) (+ (/ 1 2) m)) (- (+ beta beta) (+ (/ 1 2) m))))) (and (<= 0 (- (- beta (/ 1 2)) m)) (<= 0 (- (+ (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m))) (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m)))) Var)))))))
(check-sat)
