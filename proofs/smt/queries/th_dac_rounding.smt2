; TH-DAC, rounding: rounding to steps of δ is off by at most ½δ
; rounding to steps of δ is off by at most ½δ
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const delta Real)
(declare-const u Real)
(define-fun def1 () Real (+ (/ (* u 1) delta) (/ 1 2)))
(declare-const floor2 Real) ; floor of def1
(assert (and (<= floor2 def1) (< def1 (+ floor2 1))))
(define-fun def3 () Real (- (/ (* floor2 delta) 1) u))
(define-fun def4 () Real (ite (>= def3 0) def3 (- def3)))
(assert (> delta 0))
; what would contradict the goal
(assert (not (<= def4 (/ delta 2))))
(check-sat)
