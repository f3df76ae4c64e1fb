; TH-STIFF, shortest period: what Coulomb friction has to spare, times the period, grows from zero at the shortest period
; it does not stay
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const Delta Real)
(declare-const v Real)
(declare-const c Real)
(declare-const F Real)
(declare-const T1 Real)
(declare-const B Real)
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
(assert (> (- c (+ (/ (* K Delta) 2) (/ F 2))) 0))
(assert (> T1 0))
; what would contradict the goal
(assert (not (= (- c (+ (+ (/ (* K Delta) 2) (* B (/ Delta T1))) (/ F 2))) (- c (+ (/ (* K Delta) 2) (/ F 2))))))
(check-sat)
