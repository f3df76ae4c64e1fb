; TH-STIFF, critical speed: v_c is (c − KΔ/2)/(KT/2 − b), for b < KT/2
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const K Real)
(declare-const T Real)
(declare-const Delta Real)
(declare-const v Real)
(declare-const b Real)
(assert (> K 0))
(assert (> T 0))
(assert (> Delta 0))
(assert (> v 0))
(assert (> (/ (* K T) 2) b))
(check-sat)
