; EQ-16/17, range: quantization adds between 0 and 1/8 to the potential
; it can add more than 1/9
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NIRA)
(set-info :status sat)
(declare-const x Real)
(declare-const floor1 Int) ; floor of x
(assert (and (<= (to_real floor1) x) (< x (+ (to_real floor1) 1))))
; what would contradict the goal
(assert (not (<= (/ (* (- x (to_real floor1)) (- 1.0 (- x (to_real floor1)))) 2) (/ 1.0 9.0))))
(check-sat)
