(** * Controller tactics: the kernel's controller, which never branches, and [controller]. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions Quantizer.
Open Scope R_scope.

(** The gate of a wall on one side is a floor between -1 and 0. *)
Lemma kernel_gate : forall F q,
  F * ((floor (Rmin (Rmax q (- 1)) 0)) + 1) = gated true q F.
Proof.
  intros F q. unfold gated. destruct (Rlt_dec q 0) as [N | N].
  - assert (E : floor (Rmin (Rmax q (- 1)) 0) = -1).
    { apply (floor_unique _ (-1)). unfold Rmin, Rmax. repeat destruct Rle_dec; lra. }
    rewrite E. ring.
  - assert (E : floor (Rmin (Rmax q (- 1)) 0) = 0).
    { apply (floor_unique _ 0). unfold Rmin, Rmax. repeat destruct Rle_dec; lra. }
    rewrite E. ring.
Qed.

(** Rounding to steps that are a quotient. *)
Lemma kernel_step : forall u delta,
  ((floor (((u * 1) / delta) + (1 / 2))) * delta) / 1 = rounded_force u delta.
Proof. intros. unfold rounded_force. rewrite Rmult_1_r. field. Qed.

Lemma kernel_limit : forall u L, 0 <= L -> Rmax (Rmin u L) (- L) = clipped (- L) L u.
Proof. intros. unfold clipped, Rmin, Rmax. repeat destruct Rle_dec; lra. Qed.

(** The filter as the sum H(1) and its tails. *)
Lemma kernel_filter : forall B q q', (1 * q) + ((- B) * (q' - q)) = q + B * (q - q').
Proof. intros. ring. Qed.

Lemma no_damping : forall q q', q + 0 * (q - q') = q.
Proof. intros. ring. Qed.

Lemma no_motion : forall B q, q + B * (q - q) = q.
Proof. intros. ring. Qed.

Ltac bridge_controller :=
  intros; unfold controller, limited, stepped, measured;
  rewrite ?no_damping, ?no_motion, ?kernel_filter, ?Rmult_1_l, ?kernel_gate, ?kernel_step;
  rewrite ?kernel_limit by assumption;
  unfold gated; reflexivity.

(** The law of a wall on one side that is saturated too. *)
Ltac bridge_law :=
  intros; unfold controller_potential, controller_law, law_potential_of, clipped, clipped_below,
    linear_potential;
  try (rewrite (Rmax_left 0) by lra); field.
