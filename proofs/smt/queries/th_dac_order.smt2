; TH-DAC, order: rounded first and limited then: the limit need not be a whole step
; rounded first and limited then: the limit need not be a whole step
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const delta Real)
(declare-const L Real)
(declare-const q Real)
(define-fun def1 () Real (+ (/ (* (- (* 1 q)) 1) delta) (/ 1 2)))
(declare-const floor2 Real) ; floor of def1
(assert (and (<= floor2 def1) (< def1 (+ floor2 1))))
(define-fun def3 () Real (/ (* floor2 delta) 1))
(define-fun def4 () Real (ite (<= def3 L) def3 L))
(define-fun def5 () Real (- L))
(define-fun def6 () Real (ite (>= def4 def5) def4 def5))
(assert (> delta 0))
(assert (> L 0))
; what would contradict the goal
(assert (not (= def6 def6)))
(check-sat)
