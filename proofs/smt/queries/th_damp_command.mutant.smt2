; TH-DAMP, command: damping and rounding are paid by the step, and by what was stored before
; not when the force is off by more
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(declare-const w Real)
(declare-const d2 Real)
(declare-const g Real)
(declare-const d Real)
(declare-const d1 Real)
(define-fun def1 () Real (- w d2))
(define-fun def2 () Real (ite (>= def1 0) def1 (- def1)))
(define-fun def3 () Real (ite (>= d 0) d (- d)))
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
(assert (<= def2 (+ (/ 1 2) (/ 1 2))))
; what would contradict the goal
(assert (not (<= (* g d) (+ (+ (+ (* B (* d d)) (* B def3)) (* (/ delta 2) def3)) (- (/ (* B (+ (+ 0 (* d1 d1)) (* d2 d2))) 2) (/ (* B (+ (+ 0 (* d d)) (* d1 d1))) 2))))))
(check-sat)
