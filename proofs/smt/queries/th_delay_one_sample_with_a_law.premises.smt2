; TH-DELAY, one sample with a law: behind an encoder and any law, the step pays ½|d| + k·d², what was stored the rest
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const g Real)
(declare-const d1 Real)
(define-fun def1 () Real (ite (>= g 0) g (- g)))
(define-fun def2 () Real (+ 0 d1))
(define-fun def3 () Real (ite (>= def2 0) def2 (- def2)))
(assert (<= def1 (+ def3 (/ 1 2))))
(check-sat)
