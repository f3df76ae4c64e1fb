; TH-DAMP, cost: the step pays B·d² + B·|d|, what was stored before pays the rest
; not when the encoder is off by more than a tick
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const q Real)
(declare-const d Real)
(declare-const d1 Real)
(declare-const d2 Real)
(define-fun def1 () Real (ite (>= d 0) d (- d)))
(assert (<= 0 B))
; what would contradict the goal
(assert (not (<= (- (* (* B q) d)) (+ (+ (* B (* d d)) (* B def1)) (- (/ (* B (+ (+ 0 (* d1 d1)) (* d2 d2))) 2) (/ (* B (+ (+ 0 (* d d)) (* d1 d1))) 2))))))
(check-sat)
