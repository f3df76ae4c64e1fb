; TH-COUNTS, quantized end position: within a tick, its upper end included, generated energy against the quantized spring changes by F + n + ½ a tick, up with the end and down with the start
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_LIRA)
(set-info :status sat)
(declare-const tick Real)
(declare-const x Real)
(declare-const floor1 Int) ; floor of tick
(assert (and (<= (to_real floor1) tick) (< tick (+ (to_real floor1) 1))))
(declare-const floor2 Int) ; floor of x
(assert (and (<= (to_real floor2) x) (< x (+ (to_real floor2) 1))))
(assert (= (to_real floor1) tick))
(assert (or (and (<= tick x) (> (+ tick 1.0) x) (= (to_real floor2) tick)) (and (= x (+ tick 1.0)) (= (to_real floor2) (+ tick 1.0)))))
(check-sat)
