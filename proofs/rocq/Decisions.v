(** * Decisions: each way through the kernel's branches says what the criterion says.

    Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)

From Coq Require Import Reals.
From Passivity Require Import Definitions Stability DecisionTactics.
Open Scope R_scope.

(** ** [Region::of] (TH-REGION) *)

Lemma region_1 : forall viscous coulomb : R,
  viscous < 0 -> coulomb < 0 ->
  unstable viscous coulomb.
Proof. decide_signs. Qed.

Lemma region_2 : forall viscous coulomb : R,
  viscous < 0 -> coulomb = 0 ->
  unstable viscous coulomb.
Proof. decide_signs. Qed.

Lemma region_3 : forall viscous coulomb : R,
  viscous < 0 -> 0 < coulomb ->
  locally_stable viscous coulomb.
Proof. decide_signs. Qed.

Lemma region_4 : forall viscous coulomb : R,
  viscous = 0 -> coulomb < 0 ->
  unstable viscous coulomb.
Proof. decide_signs. Qed.

Lemma region_5 : forall viscous coulomb : R,
  viscous = 0 -> coulomb = 0 ->
  globally_stable viscous coulomb.
Proof. decide_signs. Qed.

Lemma region_6 : forall viscous coulomb : R,
  viscous = 0 -> 0 < coulomb ->
  globally_stable viscous coulomb.
Proof. decide_signs. Qed.

Lemma region_7 : forall viscous coulomb : R,
  0 < viscous -> coulomb < 0 ->
  limit_cycles viscous coulomb.
Proof. decide_signs. Qed.

Lemma region_8 : forall viscous coulomb : R,
  0 < viscous -> coulomb = 0 ->
  globally_stable viscous coulomb.
Proof. decide_signs. Qed.

Lemma region_9 : forall viscous coulomb : R,
  0 < viscous -> 0 < coulomb ->
  globally_stable viscous coulomb.
Proof. decide_signs. Qed.

(** ** [verdict::decide] at every speed *)

Lemma decide_all_1 : forall viscous coulomb : R,
  viscous < 0 -> coulomb < 0 ->
  ~ (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

Lemma decide_all_2 : forall viscous coulomb : R,
  viscous < 0 -> coulomb = 0 ->
  ~ (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

Lemma decide_all_3 : forall viscous coulomb : R,
  viscous < 0 -> 0 < coulomb ->
  ~ (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

Lemma decide_all_4 : forall viscous coulomb : R,
  viscous = 0 -> coulomb < 0 ->
  ~ (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

Lemma decide_all_5 : forall viscous coulomb : R,
  viscous = 0 -> coulomb = 0 ->
  (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

Lemma decide_all_6 : forall viscous coulomb : R,
  viscous = 0 -> 0 < coulomb ->
  (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

Lemma decide_all_7 : forall viscous coulomb : R,
  0 < viscous -> coulomb < 0 ->
  ~ (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

Lemma decide_all_8 : forall viscous coulomb : R,
  0 < viscous -> coulomb = 0 ->
  (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

Lemma decide_all_9 : forall viscous coulomb : R,
  0 < viscous -> 0 < coulomb ->
  (holds_at_all viscous coulomb).
Proof. decide_signs. Qed.

(** ** [verdict::decide] up to a speed *)

Lemma decide_up_to_1 : forall viscous coulomb V : R,
  viscous < 0 -> coulomb < 0 ->
  0 < V -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_2 : forall viscous coulomb V : R,
  viscous < 0 -> coulomb = 0 ->
  0 < V -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_3 : forall viscous coulomb V : R,
  viscous < 0 -> 0 < coulomb -> ((viscous * V) + coulomb) < 0 ->
  0 < V -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_4 : forall viscous coulomb V : R,
  viscous < 0 -> 0 < coulomb -> ((viscous * V) + coulomb) = 0 ->
  0 < V -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_5 : forall viscous coulomb V : R,
  viscous < 0 -> 0 < coulomb -> 0 < ((viscous * V) + coulomb) ->
  0 < V -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_6 : forall viscous coulomb V : R,
  viscous = 0 -> coulomb < 0 ->
  0 < V -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_7 : forall viscous coulomb V : R,
  viscous = 0 -> coulomb = 0 ->
  0 < V -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_8 : forall viscous coulomb V : R,
  viscous = 0 -> 0 < coulomb ->
  0 < V -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_9 : forall viscous coulomb V : R,
  0 < viscous -> coulomb < 0 ->
  0 < V -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_10 : forall viscous coulomb V : R,
  0 < viscous -> coulomb = 0 ->
  0 < V -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_up_to_11 : forall viscous coulomb V : R,
  0 < viscous -> 0 < coulomb ->
  0 < V -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

(** ** [verdict::decide] up to a speed given by its square *)

Lemma decide_squared_1 : forall viscous coulomb V2 : R,
  viscous < 0 -> coulomb < 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_2 : forall viscous coulomb V2 : R,
  viscous < 0 -> coulomb = 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_3 : forall viscous coulomb V2 : R,
  viscous < 0 -> 0 < coulomb -> ((coulomb * coulomb) - ((viscous * viscous) * V2)) < 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_4 : forall viscous coulomb V2 : R,
  viscous < 0 -> 0 < coulomb -> ((coulomb * coulomb) - ((viscous * viscous) * V2)) = 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_5 : forall viscous coulomb V2 : R,
  viscous < 0 -> 0 < coulomb -> 0 < ((coulomb * coulomb) - ((viscous * viscous) * V2)) ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_6 : forall viscous coulomb V2 : R,
  viscous = 0 -> coulomb < 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_7 : forall viscous coulomb V2 : R,
  viscous = 0 -> coulomb = 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_8 : forall viscous coulomb V2 : R,
  viscous = 0 -> 0 < coulomb ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_9 : forall viscous coulomb V2 : R,
  0 < viscous -> coulomb < 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_10 : forall viscous coulomb V2 : R,
  0 < viscous -> coulomb = 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma decide_squared_11 : forall viscous coulomb V2 : R,
  0 < viscous -> 0 < coulomb ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

(** ** [start::holds_up_to] (TH-START) *)

Lemma start_1 : forall viscous coulomb V2 : R,
  viscous < 0 -> coulomb < 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_2 : forall viscous coulomb V2 : R,
  viscous < 0 -> coulomb = 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_3 : forall viscous coulomb V2 : R,
  viscous < 0 -> 0 < coulomb -> ((coulomb * coulomb) - ((viscous * viscous) * V2)) < 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_4 : forall viscous coulomb V2 : R,
  viscous < 0 -> 0 < coulomb -> ((coulomb * coulomb) - ((viscous * viscous) * V2)) = 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_5 : forall viscous coulomb V2 : R,
  viscous < 0 -> 0 < coulomb -> 0 < ((coulomb * coulomb) - ((viscous * viscous) * V2)) ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_6 : forall viscous coulomb V2 : R,
  viscous = 0 -> coulomb < 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_7 : forall viscous coulomb V2 : R,
  viscous = 0 -> coulomb = 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_8 : forall viscous coulomb V2 : R,
  viscous = 0 -> 0 < coulomb ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_9 : forall viscous coulomb V2 : R,
  0 < viscous -> coulomb < 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> ~ (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_10 : forall viscous coulomb V2 : R,
  0 < viscous -> coulomb = 0 ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

Lemma start_11 : forall viscous coulomb V2 : R,
  0 < viscous -> 0 < coulomb ->
  forall V, 0 < V -> V ^ 2 = V2 -> (holds_up_to viscous coulomb V).
Proof. decide_signs. Qed.

(** ** [Loop::decide] over tolerances of both frictions, at every speed *)

Lemma box_all_1 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_2 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_3 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_4 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_5 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_6 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_7 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_8 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_9 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_10 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_11 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_12 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_13 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_14 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_15 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_16 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_17 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_18 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_19 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_20 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_21 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_22 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_23 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_24 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_25 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_26 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_27 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_28 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_29 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_30 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_31 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_32 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_33 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_34 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_35 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_36 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_37 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_38 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_39 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_40 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_41 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_42 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_43 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_44 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_45 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_46 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_47 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_48 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_49 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_50 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_51 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_52 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_53 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_54 : forall b0 b1 c0 c1 : R,
  (b0 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_55 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_56 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_57 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_58 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_59 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_60 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_61 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  ~ (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_62 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_63 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) < 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> ~ (holds_at_all (b0 - ((1 * 1) * ((1 / 2) + 0))) (c0 - ((1 * 1) / 2))) /\ (holds_at_all (b1 - ((1 * 1) * ((1 / 2) + 0))) (c1 - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_64 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_65 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_66 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_67 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_68 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_69 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_70 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_71 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_72 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> (c0 - ((1 * 1) / 2)) = 0 -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_73 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_74 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_75 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_76 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_77 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_78 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> (b1 - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_79 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) < 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_80 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> (c1 - ((1 * 1) / 2)) = 0 ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

Lemma box_all_81 : forall b0 b1 c0 c1 : R,
  0 < (b0 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c0 - ((1 * 1) / 2)) -> 0 < (b1 - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (c1 - ((1 * 1) / 2)) ->
  b0 <= b1 -> c0 <= c1 -> forall b c, b0 <= b <= b1 -> c0 <= c <= c1 ->
  (holds_at_all (b - ((1 * 1) * ((1 / 2) + 0))) (c - ((1 * 1) / 2))).
Proof. decide_box. Qed.

(** ** [Loop::decide] over a tolerance of the bound on the speed *)

Lemma box_up_to_1 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (sigma - ((1 * 1) / 2)) < 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  ~ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_2 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> (sigma - ((1 * 1) / 2)) = 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  ~ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_3 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) < 0 -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) < 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  ~ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_4 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) < 0 -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) = 0 ->
  0 < V0 -> V0 <= V1 ->
  ~ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V1) /\ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V0).
Proof. decide_bound. Qed.

Lemma box_up_to_5 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) < 0 -> 0 < (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) ->
  0 < V0 -> V0 <= V1 ->
  ~ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V1) /\ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V0).
Proof. decide_bound. Qed.

Lemma box_up_to_6 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) = 0 -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) < 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_7 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) = 0 -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) = 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_8 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) = 0 -> 0 < (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_9 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> 0 < (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) < 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_10 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> 0 < (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) -> (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) = 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_11 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) < 0 -> 0 < (sigma - ((1 * 1) / 2)) -> 0 < (((beta - ((1 * 1) * ((1 / 2) + 0))) * V1) + (sigma - ((1 * 1) / 2))) -> 0 < (((beta - ((1 * 1) * ((1 / 2) + 0))) * V0) + (sigma - ((1 * 1) / 2))) ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_12 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (sigma - ((1 * 1) / 2)) < 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  ~ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_13 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) = 0 -> (sigma - ((1 * 1) / 2)) = 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_14 : forall beta sigma V0 V1 : R,
  (beta - ((1 * 1) * ((1 / 2) + 0))) = 0 -> 0 < (sigma - ((1 * 1) / 2)) ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_15 : forall beta sigma V0 V1 : R,
  0 < (beta - ((1 * 1) * ((1 / 2) + 0))) -> (sigma - ((1 * 1) / 2)) < 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  ~ (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_16 : forall beta sigma V0 V1 : R,
  0 < (beta - ((1 * 1) * ((1 / 2) + 0))) -> (sigma - ((1 * 1) / 2)) = 0 ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

Lemma box_up_to_17 : forall beta sigma V0 V1 : R,
  0 < (beta - ((1 * 1) * ((1 / 2) + 0))) -> 0 < (sigma - ((1 * 1) / 2)) ->
  0 < V0 -> V0 <= V1 -> forall V, V0 <= V <= V1 ->
  (holds_up_to (beta - ((1 * 1) * ((1 / 2) + 0))) (sigma - ((1 * 1) / 2)) V).
Proof. decide_bound. Qed.

(** ** [transfer::is_stable] of one pole and of two (TH-LTI) *)

Lemma stable_one_1 : forall d0 d1 : R,
  ((Rabs d0) - (Rabs d1)) < 0 ->
  d0 <> 0 -> ~ (pole_inside d0 d1).
Proof. decide_stability. Qed.

Lemma stable_one_2 : forall d0 d1 : R,
  ((Rabs d0) - (Rabs d1)) = 0 ->
  d0 <> 0 -> ~ (pole_inside d0 d1).
Proof. decide_stability. Qed.

Lemma stable_one_3 : forall d0 d1 : R,
  0 < ((Rabs d0) - (Rabs d1)) ->
  d0 <> 0 -> (pole_inside d0 d1).
Proof. decide_stability. Qed.

Lemma stable_two_1 : forall d0 d1 d2 : R,
  ((Rabs d0) - (Rabs d2)) < 0 ->
  d0 <> 0 -> ~ (poles_inside d0 d1 d2).
Proof. decide_stability. Qed.

Lemma stable_two_2 : forall d0 d1 d2 : R,
  ((Rabs d0) - (Rabs d2)) = 0 ->
  d0 <> 0 -> ~ (poles_inside d0 d1 d2).
Proof. decide_stability. Qed.

Lemma stable_two_3 : forall d0 d1 d2 : R,
  0 < ((Rabs d0) - (Rabs d2)) -> ((Rabs (d0 - ((d2 / d0) * d2))) - (Rabs (d1 - ((d2 / d0) * d1)))) < 0 ->
  d0 <> 0 -> ~ (poles_inside d0 d1 d2).
Proof. decide_stability. Qed.

Lemma stable_two_4 : forall d0 d1 d2 : R,
  0 < ((Rabs d0) - (Rabs d2)) -> ((Rabs (d0 - ((d2 / d0) * d2))) - (Rabs (d1 - ((d2 / d0) * d1)))) = 0 ->
  d0 <> 0 -> ~ (poles_inside d0 d1 d2).
Proof. decide_stability. Qed.

Lemma stable_two_5 : forall d0 d1 d2 : R,
  0 < ((Rabs d0) - (Rabs d2)) -> 0 < ((Rabs (d0 - ((d2 / d0) * d2))) - (Rabs (d1 - ((d2 / d0) * d1)))) ->
  d0 <> 0 -> (poles_inside d0 d1 d2).
Proof. decide_stability. Qed.
