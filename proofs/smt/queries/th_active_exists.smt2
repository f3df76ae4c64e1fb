; TH-ACTIVE, exists: where β < ½ or σ < ½ the code comes to consider a cycle
; where β < ½ or σ < ½ the code comes to consider a cycle
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (/ (/ (- (* 0 (- 1 (+ beta beta))) (- (+ sigma sigma) 1)) (+ beta beta)) 2))
(define-fun def2 () Real (ite (<= 1 def1) 1 def1))
(define-fun def3 () Real (/ (- (+ sigma sigma) 1) (- 1 (+ beta beta))))
(declare-const floor4 Real) ; floor of def3
(assert (and (<= floor4 def3) (< def3 (+ floor4 1))))
(define-fun def5 () Real (/ (/ (- (* (+ floor4 1) (- 1 (+ beta beta))) (- (+ sigma sigma) 1)) (+ beta beta)) 2))
(define-fun def6 () Real (ite (<= 1 def5) 1 def5))
(assert (<= 0 beta))
(assert (<= 0 sigma))
(assert (or (> (/ 1 2) beta) (> (/ 1 2) sigma)))
; what would contradict the goal
(assert (not (not (or (and (> 0 (- (+ sigma sigma) 1)) (> 0 (- 1 (+ beta beta))) (> beta 0) (> 0 def2)) (and (> 0 (- (+ sigma sigma) 1)) (> 0 (- 1 (+ beta beta))) (> beta 0) (= def2 0)) (and (> 0 (- (+ sigma sigma) 1)) (= (- 1 (+ beta beta)) 0) (> beta 0) (> 0 def2)) (and (> 0 (- (+ sigma sigma) 1)) (= (- 1 (+ beta beta)) 0) (> beta 0) (= def2 0)) (and (> 0 (- (+ sigma sigma) 1)) (> (- 1 (+ beta beta)) 0) (> beta 0) (> 0 def2)) (and (> 0 (- (+ sigma sigma) 1)) (> (- 1 (+ beta beta)) 0) (> beta 0) (= def2 0)) (and (= (- (+ sigma sigma) 1) 0) (> 0 (- 1 (+ beta beta)))) (and (= (- (+ sigma sigma) 1) 0) (= (- 1 (+ beta beta)) 0)) (and (= (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (> beta 0) (> 0 def6)) (and (= (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (> beta 0) (= def6 0)) (and (> (- (+ sigma sigma) 1) 0) (> 0 (- 1 (+ beta beta)))) (and (> (- (+ sigma sigma) 1) 0) (= (- 1 (+ beta beta)) 0)) (and (> (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (> beta 0) (> 0 def6)) (and (> (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (> beta 0) (= def6 0))))))
(check-sat)
