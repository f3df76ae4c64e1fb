; TH-REGION, speeds: a region is the set of speeds at which the criterion holds
; with the inequality of local stability turned round it is not
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const v Real)
(declare-const beta Real)
(declare-const sigma Real)
(assert (> v 0))
; what would contradict the goal
(assert (not (and (or (not (and (> 0 (- beta (/ 1 2))) (> 0 (- sigma (/ 1 2))))) (not (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2)))))) (or (not (and (> 0 (- beta (/ 1 2))) (= (- sigma (/ 1 2)) 0))) (not (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2)))))) (or (not (and (> 0 (- beta (/ 1 2))) (> (- sigma (/ 1 2)) 0))) (and (or (not (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2))))) (<= (/ (- (- sigma (/ 1 2))) (- beta (/ 1 2))) v)) (or (not (<= (/ (- (- sigma (/ 1 2))) (- beta (/ 1 2))) v)) (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2))))))) (or (not (and (= (- beta (/ 1 2)) 0) (> 0 (- sigma (/ 1 2))))) (not (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2)))))) (or (not (and (= (- beta (/ 1 2)) 0) (= (- sigma (/ 1 2)) 0))) (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2))))) (or (not (and (= (- beta (/ 1 2)) 0) (> (- sigma (/ 1 2)) 0))) (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2))))) (or (not (and (> (- beta (/ 1 2)) 0) (> 0 (- sigma (/ 1 2))))) (and (> (/ (- (- sigma (/ 1 2))) (- beta (/ 1 2))) 0) (and (or (not (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2))))) (<= (/ (- (- sigma (/ 1 2))) (- beta (/ 1 2))) v)) (or (not (<= (/ (- (- sigma (/ 1 2))) (- beta (/ 1 2))) v)) (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2)))))))) (or (not (and (> (- beta (/ 1 2)) 0) (= (- sigma (/ 1 2)) 0))) (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2))))) (or (not (and (> (- beta (/ 1 2)) 0) (> (- sigma (/ 1 2)) 0))) (<= 0 (+ (* (- beta (/ 1 2)) v) (- sigma (/ 1 2))))))))
(check-sat)
