; TH-DAMP, commands: the force held is off the law of the wall by at most B|q − q₁| + ½δ
; the premises can be met
; printed from the kernel's code; expected answer: sat
(set-option :produce-models true)
(set-logic QF_NRA)
(set-info :status sat)
(declare-const B Real)
(declare-const delta Real)
(declare-const L Real)
(assert (<= 0 B))
(assert (> delta 0))
(assert (> L 0))
(check-sat)
