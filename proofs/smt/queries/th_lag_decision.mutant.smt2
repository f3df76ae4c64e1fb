; TH-LAG, decision: more variance is never decided for less friction: an enclosure's upper end is safe
; less variance is not safe
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const m Real)
(declare-const Var Real)
(declare-const more Real)
(declare-const beta Real)
(assert (<= 0 m))
(assert (<= 0 Var))
(assert (<= Var more))
; what would contradict the goal
(assert (not (or (not (and (<= 0 (- (- beta (/ 1 2)) m)) (<= 0 (- (+ (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m))) (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m)))) Var)))) (and (<= 0 (- (- beta (/ 1 2)) m)) (<= 0 (- (+ (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m))) (+ (* beta (- (- beta (/ 1 2)) m)) (* beta (- (- beta (/ 1 2)) m)))) more))))))
(check-sat)
