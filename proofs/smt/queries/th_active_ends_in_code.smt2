; TH-ACTIVE, ends in code: a cycle that the code considers starts in tick 0
; a cycle that the code considers starts in tick 0
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (- (/ 1 1)))
(declare-const floor2 Real) ; floor of def1
(assert (and (<= floor2 def1) (< def1 (+ floor2 1))))
(define-fun def3 () Real (/ (/ (- (* 0 (- 1 (+ beta beta))) (- (+ sigma sigma) 1)) (+ beta beta)) 2))
(define-fun def4 () Real (ite (<= 1 def3) 1 def3))
(define-fun def5 () Real (- (/ 1 def4)))
(declare-const floor6 Real) ; floor of def5
(assert (and (<= floor6 def5) (< def5 (+ floor6 1))))
(define-fun def7 () Real (/ (- (+ sigma sigma) 1) (- 1 (+ beta beta))))
(declare-const floor8 Real) ; floor of def7
(assert (and (<= floor8 def7) (< def7 (+ floor8 1))))
(define-fun def9 () Real (/ (/ (- (* (+ floor8 1) (- 1 (+ beta beta))) (- (+ sigma sigma) 1)) (+ beta beta)) 2))
(define-fun def10 () Real (ite (<= 1 def9) 1 def9))
(define-fun def11 () Real (- (/ 1 def10)))
(declare-const floor12 Real) ; floor of def11
(assert (and (<= floor12 def11) (< def11 (+ floor12 1))))
(assert (<= 0 beta))
(assert (<= 0 sigma))
; what would contradict the goal
(assert (not (and (or (not (and (> 0 (- (+ sigma sigma) 1)) (> 0 (- 1 (+ beta beta))) (> 0 beta))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (> 0 (- (+ sigma sigma) 1)) (> 0 (- 1 (+ beta beta))) (= beta 0))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (> 0 (- (+ sigma sigma) 1)) (> 0 (- 1 (+ beta beta))) (> beta 0) (> def4 0))) (and (<= 0 (- 1 (/ 1 (- floor6)))) (> 1 (- 1 (/ 1 (- floor6)))))) (or (not (and (> 0 (- (+ sigma sigma) 1)) (= (- 1 (+ beta beta)) 0) (> 0 beta))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (> 0 (- (+ sigma sigma) 1)) (= (- 1 (+ beta beta)) 0) (= beta 0))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (> 0 (- (+ sigma sigma) 1)) (= (- 1 (+ beta beta)) 0) (> beta 0) (> def4 0))) (and (<= 0 (- 1 (/ 1 (- floor6)))) (> 1 (- 1 (/ 1 (- floor6)))))) (or (not (and (> 0 (- (+ sigma sigma) 1)) (> (- 1 (+ beta beta)) 0) (> 0 beta))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (> 0 (- (+ sigma sigma) 1)) (> (- 1 (+ beta beta)) 0) (= beta 0))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (> 0 (- (+ sigma sigma) 1)) (> (- 1 (+ beta beta)) 0) (> beta 0) (> def4 0))) (and (<= 0 (- 1 (/ 1 (- floor6)))) (> 1 (- 1 (/ 1 (- floor6)))))) (or (not (and (= (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (> 0 beta))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (= (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (= beta 0))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (= (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (> beta 0) (> def10 0))) (and (<= 0 (- 1 (/ 1 (- floor12)))) (> 1 (- 1 (/ 1 (- floor12)))))) (or (not (and (> (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (> 0 beta))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (> (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (= beta 0))) (and (<= 0 (- 1 (/ 1 (- floor2)))) (> 1 (- 1 (/ 1 (- floor2)))))) (or (not (and (> (- (+ sigma sigma) 1) 0) (> (- 1 (+ beta beta)) 0) (> beta 0) (> def10 0))) (and (<= 0 (- 1 (/ 1 (- floor12)))) (> 1 (- 1 (/ 1 (- floor12)))))))))
(check-sat)
