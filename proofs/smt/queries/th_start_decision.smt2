; TH-START, decision: the decision up to V is that of every speed up to V
; the decision up to V is that of every speed up to V
; printed from the kernel's code; expected answer: unsat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status unsat)
(declare-const bound Real)
(declare-const v Real)
(declare-const viscous Real)
(declare-const coulomb Real)
(assert (> bound 0))
(assert (> v 0))
(assert (<= v bound))
; what would contradict the goal
(assert (not (and (or (not (and (> 0 viscous) (> 0 coulomb))) (or (> 0 (+ (* viscous bound) coulomb)) (> 0 coulomb) (and (= coulomb 0) (> 0 viscous)))) (or (not (and (> 0 viscous) (= coulomb 0))) (or (> 0 (+ (* viscous bound) coulomb)) (> 0 coulomb) (and (= coulomb 0) (> 0 viscous)))) (or (not (and (> 0 viscous) (> coulomb 0) (> 0 (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound)))))) (or (> 0 (+ (* viscous bound) coulomb)) (> 0 coulomb) (and (= coulomb 0) (> 0 viscous)))) (or (not (and (> 0 viscous) (> coulomb 0) (= (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound))) 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> 0 viscous) (> coulomb 0) (> (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound))) 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (= viscous 0) (> 0 coulomb))) (or (> 0 (+ (* viscous bound) coulomb)) (> 0 coulomb) (and (= coulomb 0) (> 0 viscous)))) (or (not (and (= viscous 0) (= coulomb 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (= viscous 0) (> coulomb 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> viscous 0) (> 0 coulomb))) (or (> 0 (+ (* viscous bound) coulomb)) (> 0 coulomb) (and (= coulomb 0) (> 0 viscous)))) (or (not (and (> viscous 0) (= coulomb 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> viscous 0) (> coulomb 0))) (<= 0 (+ (* viscous v) coulomb))))))
(check-sat)
