; TH-STIFF, critical speed: v_c is (c − KΔ/2)/(KT/2 − b), for b < KT/2
; v_c is (c − KΔ/2)/(KT/2 − b), for b < KT/2
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const K Real)
(declare-const T Real)
(declare-const Delta Real)
(declare-const v Real)
(declare-const b Real)
(declare-const c Real)
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
(assert (> (/ (* K T) 2) b))
; what would contradict the goal
(assert (not (and (= (/ (- (- c (/ (* K Delta) 2))) (- b (* (* K T) (+ (/ 1 2) 0)))) (/ (- c (/ (* K Delta) 2)) (- (/ (* K T) 2) b))) (and (or (not (<= 0 (+ (* (- b (* (* K T) (+ (/ 1 2) 0))) v) (- c (/ (* K Delta) 2))))) (<= v (/ (- (- c (/ (* K Delta) 2))) (- b (* (* K T) (+ (/ 1 2) 0)))))) (or (not (<= v (/ (- (- c (/ (* K Delta) 2))) (- b (* (* K T) (+ (/ 1 2) 0)))))) (<= 0 (+ (* (- b (* (* K T) (+ (/ 1 2) 0))) v) (- c (/ (* K Delta) 2)))))))))
(check-sat)
