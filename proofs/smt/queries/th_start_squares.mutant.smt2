; TH-START, squares: compared in squares, the answer is that of every speed up to V
; it is not always yes
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const bound Real)
(declare-const v Real)
(declare-const viscous Real)
(declare-const coulomb Real)
(assert (> bound 0))
(assert (> v 0))
(assert (<= v bound))
; what would contradict the goal
(assert (not (and (or (not (and (> 0 viscous) (> 0 coulomb))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> 0 viscous) (= coulomb 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> 0 viscous) (> coulomb 0) (> 0 (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound)))))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> 0 viscous) (> coulomb 0) (= (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound))) 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> 0 viscous) (> coulomb 0) (> (- (* coulomb coulomb) (* (* viscous viscous) (* bound bound))) 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (= viscous 0) (> 0 coulomb))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (= viscous 0) (= coulomb 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (= viscous 0) (> coulomb 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> viscous 0) (> 0 coulomb))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> viscous 0) (= coulomb 0))) (<= 0 (+ (* viscous v) coulomb))) (or (not (and (> viscous 0) (> coulomb 0))) (<= 0 (+ (* viscous v) coulomb))))))
(check-sat)
