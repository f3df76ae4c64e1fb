; TH-INTERVAL, second half: where (8) holds, ½d² + ½|d| is at most what is dissipated
; not in an interval longer than a sampling period
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const dtau Real)
(declare-const beta Real)
(declare-const x1 Real)
(declare-const x0 Real)
(declare-const sigma Real)
(define-fun def1 () Real (- x1 x0))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(assert (> dtau 0))
(assert (<= 0 (+ (* (- beta (* (* 1 1) (+ (/ 1 2) 0))) (/ def2 dtau)) (- sigma (/ (* 1 1) 2)))))
; what would contradict the goal
(assert (not (<= (/ (* def2 (+ def2 1)) 2) (* def2 (+ (* beta (/ def2 dtau)) sigma)))))
(check-sat)
