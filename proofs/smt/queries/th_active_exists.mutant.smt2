; TH-ACTIVE, exists: where β < ½ or σ < ½ the code comes to consider a cycle
; not where β ≥ ½ and σ ≥ ½
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (/ (/ (- (* 0.0 (- 1.0 (+ beta beta))) (- (+ sigma sigma) 1.0)) (+ beta beta)) 2))
(define-fun def2 () Real (ite (<= 1.0 def1) 1.0 def1))
(define-fun def3 () Real (/ (- (+ sigma sigma) 1.0) (- 1.0 (+ beta beta))))
(declare-const floor4 Int) ; floor of def3
(assert (and (<= (to_real floor4) def3) (< def3 (+ (to_real floor4) 1))))
(define-fun def5 () Real (/ (/ (- (* (+ (to_real floor4) 1.0) (- 1.0 (+ beta beta))) (- (+ sigma sigma) 1.0)) (+ beta beta)) 2))
(define-fun def6 () Real (ite (<= 1.0 def5) 1.0 def5))
(assert (<= 0.0 beta))
(assert (<= 0.0 sigma))
(assert (= beta (/ 1.0 1.0)))
(assert (= sigma (/ 1.0 1.0)))
; what would contradict the goal
(assert (not (not (or (and (> 0.0 (- (+ sigma sigma) 1.0)) (> 0.0 (- 1.0 (+ beta beta))) (> beta 0.0) (> 0.0 def2)) (and (> 0.0 (- (+ sigma sigma) 1.0)) (> 0.0 (- 1.0 (+ beta beta))) (> beta 0.0) (= def2 0.0)) (and (> 0.0 (- (+ sigma sigma) 1.0)) (= (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (> 0.0 def2)) (and (> 0.0 (- (+ sigma sigma) 1.0)) (= (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (= def2 0.0)) (and (> 0.0 (- (+ sigma sigma) 1.0)) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (> 0.0 def2)) (and (> 0.0 (- (+ sigma sigma) 1.0)) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (= def2 0.0)) (and (= (- (+ sigma sigma) 1.0) 0.0) (> 0.0 (- 1.0 (+ beta beta)))) (and (= (- (+ sigma sigma) 1.0) 0.0) (= (- 1.0 (+ beta beta)) 0.0)) (and (= (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (> 0.0 def6)) (and (= (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (= def6 0.0)) (and (> (- (+ sigma sigma) 1.0) 0.0) (> 0.0 (- 1.0 (+ beta beta)))) (and (> (- (+ sigma sigma) 1.0) 0.0) (= (- 1.0 (+ beta beta)) 0.0)) (and (> (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (> 0.0 def6)) (and (> (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (= def6 0.0))))))
(check-sat)
