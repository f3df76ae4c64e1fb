(** * Decisions: each way through the kernel's branches says what the criterion says.

    Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)

From Coq Require Import Reals.
From Passivity Require Import Definitions DecisionTactics.
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
