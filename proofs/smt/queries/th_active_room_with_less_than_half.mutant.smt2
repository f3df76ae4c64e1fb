; TH-ACTIVE, room with less than half: in a cycle that the code considers friction leaves room: 2βa < m + 1 − 2βm − 2σ
; nothing is left of a tick
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const beta Real)
(declare-const sigma Real)
(define-fun def1 () Real (- (/ 1.0 1.0)))
(declare-const floor2 Int) ; floor of def1
(assert (and (<= (to_real floor2) def1) (< def1 (+ (to_real floor2) 1))))
(define-fun def3 () Real (/ (/ (- (* 0.0 (- 1.0 (+ beta beta))) (- (+ sigma sigma) 1.0)) (+ beta beta)) 2))
(define-fun def4 () Real (ite (<= 1.0 def3) 1.0 def3))
(define-fun def5 () Real (- (/ 1.0 def4)))
(declare-const floor6 Int) ; floor of def5
(assert (and (<= (to_real floor6) def5) (< def5 (+ (to_real floor6) 1))))
(define-fun def7 () Real (/ (- (+ sigma sigma) 1.0) (- 1.0 (+ beta beta))))
(declare-const floor8 Int) ; floor of def7
(assert (and (<= (to_real floor8) def7) (< def7 (+ (to_real floor8) 1))))
(define-fun def9 () Real (/ (/ (- (* (+ (to_real floor8) 1.0) (- 1.0 (+ beta beta))) (- (+ sigma sigma) 1.0)) (+ beta beta)) 2))
(define-fun def10 () Real (ite (<= 1.0 def9) 1.0 def9))
(define-fun def11 () Real (- (/ 1.0 def10)))
(declare-const floor12 Int) ; floor of def11
(assert (and (<= (to_real floor12) def11) (< def11 (+ (to_real floor12) 1))))
(assert (<= 0.0 beta))
(assert (<= 0.0 sigma))
(assert (and (> beta 0.0) (> (/ 1.0 2) beta)))
(assert (> (/ 1.0 2) sigma))
(assert (= beta (/ 1.0 4.0)))
(assert (= sigma (/ 1.0 4.0)))
; what would contradict the goal
(assert (not (and (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (> 0.0 (- 1.0 (+ beta beta))) (> 0.0 beta))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 0.0))) (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (> 0.0 (- 1.0 (+ beta beta))) (= beta 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 0.0))) (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (> 0.0 (- 1.0 (+ beta beta))) (> beta 0.0) (> def4 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor6)))) (+ 1.0 0.0))) (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (= (- 1.0 (+ beta beta)) 0.0) (> 0.0 beta))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 0.0))) (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (= (- 1.0 (+ beta beta)) 0.0) (= beta 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 0.0))) (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (= (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (> def4 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor6)))) (+ 1.0 0.0))) (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (> (- 1.0 (+ beta beta)) 0.0) (> 0.0 beta))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 0.0))) (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (> (- 1.0 (+ beta beta)) 0.0) (= beta 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 0.0))) (or (not (and (> 0.0 (- (+ sigma sigma) 1.0)) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (> def4 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor6)))) (+ 1.0 0.0))) (or (not (and (= (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (> 0.0 beta))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 (+ (to_real floor8) 1.0)))) (or (not (and (= (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (= beta 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 (+ (to_real floor8) 1.0)))) (or (not (and (= (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (> def10 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor12)))) (+ 1.0 (+ (to_real floor8) 1.0)))) (or (not (and (> (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (> 0.0 beta))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 (+ (to_real floor8) 1.0)))) (or (not (and (> (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (= beta 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor2)))) (+ 1.0 (+ (to_real floor8) 1.0)))) (or (not (and (> (- (+ sigma sigma) 1.0) 0.0) (> (- 1.0 (+ beta beta)) 0.0) (> beta 0.0) (> def10 0.0))) (> (- 1.0 (/ 1.0 (- (to_real floor12)))) (+ 1.0 (+ (to_real floor8) 1.0)))))))
(check-sat)
