; TH-SMOOTH, witness: without an encoder a cycle is found exactly where β < ½, and gains 2(½d² − βd² − σd)
; not always
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const beta Real)
(declare-const sigma Real)
(assert (<= 0 beta))
(assert (<= 0 sigma))
; what would contradict the goal
(assert (not (not (or (> 0 (- (/ 1 2) beta)) (= (- (/ 1 2) beta) 0) (and (> (- (/ 1 2) beta) 0) (> 0 (/ sigma (- (/ 1 2) beta))) (> 0 (+ (* 1 (- (* (- (/ 1 2) beta) 1) sigma)) (* 1 (- (* (- (/ 1 2) beta) 1) sigma))))) (and (> (- (/ 1 2) beta) 0) (> 0 (/ sigma (- (/ 1 2) beta))) (= (+ (* 1 (- (* (- (/ 1 2) beta) 1) sigma)) (* 1 (- (* (- (/ 1 2) beta) 1) sigma))) 0)) (and (> (- (/ 1 2) beta) 0) (= (/ sigma (- (/ 1 2) beta)) 0) (> 0 (+ (* 1 (- (* (- (/ 1 2) beta) 1) sigma)) (* 1 (- (* (- (/ 1 2) beta) 1) sigma))))) (and (> (- (/ 1 2) beta) 0) (= (/ sigma (- (/ 1 2) beta)) 0) (= (+ (* 1 (- (* (- (/ 1 2) beta) 1) sigma)) (* 1 (- (* (- (/ 1 2) beta) 1) sigma))) 0)) (and (> (- (/ 1 2) beta) 0) (> (/ sigma (- (/ 1 2) beta)) 0) (> 0 (+ (* (+ (/ sigma (- (/ 1 2) beta)) (/ sigma (- (/ 1 2) beta))) (- (* (- (/ 1 2) beta) (+ (/ sigma (- (/ 1 2) beta)) (/ sigma (- (/ 1 2) beta)))) sigma)) (* (+ (/ sigma (- (/ 1 2) beta)) (/ sigma (- (/ 1 2) beta))) (- (* (- (/ 1 2) beta) (+ (/ sigma (- (/ 1 2) beta)) (/ sigma (- (/ 1 2) beta)))) sigma))))) (and (> (- (/ 1 2) beta) 0) (> (/ sigma (- (/ 1 2) beta)) 0) (= (+ (* (+ (/ sigma (- (/ 1 2) beta)) (/ sigma (- (/ 1 2) beta))) (- (* (- (/ 1 2) beta) (+ (/ sigma (- (/ 1 2) beta)) (/ sigma (- (/ 1 2) beta)))) sigma)) (* (+ (/ sigma (- (/ 1 2) beta)) (/ sigma (- (/ 1 2) beta))) (- (* (- (/ 1 2) beta) (+ (/ sigma (- (/ 1 2) beta)) (/ sigma (- (/ 1 2) beta)))) sigma))) 0))))))
(check-sat)
