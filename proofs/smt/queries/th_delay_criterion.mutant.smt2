; TH-DELAY, criterion: the costs of the effects add
; B is charged to both
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const delta Real)
; what would contradict the goal
(assert (not (= (+ (+ (/ (* 1 1) 2) (* B (/ 1 1))) (/ delta 2)) (- (+ (/ (+ 1 delta) 2) B) B))))
(check-sat)
