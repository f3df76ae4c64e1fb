; TH-COUNTS, vertex back: where the slope changes its sign that is a value between the ends
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const from Real)
(declare-const to Real)
(declare-const alpha Real)
(declare-const gamma Real)
(declare-const sigma Real)
(declare-const d Real)
(assert (> 0 from))
(assert (<= to 0))
(assert (<= from to))
(assert (or (> 0 alpha) (> alpha 0)))
(assert (or (and (> 0 (+ (* (+ alpha alpha) from) (- gamma sigma))) (> (+ (* (+ alpha alpha) to) (- gamma sigma)) 0)) (and (> (+ (* (+ alpha alpha) from) (- gamma sigma)) 0) (> 0 (+ (* (+ alpha alpha) to) (- gamma sigma))))))
(assert (= (* d (+ alpha alpha)) (- (- gamma sigma))))
(check-sat)
