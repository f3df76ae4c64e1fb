(** * Active: TH-ACTIVE, the witness cycles. *)

From Coq Require Import Reals Lra Lia Psatz.
From Passivity Require Import Definitions Quantizer Generation.
Open Scope R_scope.

(** The held forces of the cycle between n - a and n + m do the work (m + 1)(m + a). *)
Theorem TH_ACTIVE_work : forall (n : Z) (m : nat) a, 0 < a <= 1 ->
  let low := IZR n - a in
  let high := IZR n + INR m in
  held_force low * (high - low) + held_force high * (low - high) = cycle_work (INR m) a.
Proof.
  intros n m a Ha low high. unfold held_force, measured, cycle_work.
  replace (floor low) with (IZR (n - 1))
    by (symmetry; apply floor_unique; unfold low; rewrite minus_IZR; lra).
  replace (floor high) with (IZR (n + Z.of_nat m))
    by (symmetry; apply floor_unique; unfold high; rewrite plus_IZR, <- INR_IZR_INZ; lra).
  rewrite minus_IZR, plus_IZR, <- INR_IZR_INZ. unfold low, high. field.
Qed.

(** Friction takes what (26) allows it at least, one interval each way at constant speed. *)
Theorem TH_ACTIVE_friction : forall m a beta sigma, 0 <= m + a ->
  dissipated_lower beta sigma (m + a) 1 + dissipated_lower beta sigma (- (m + a)) 1
  = cycle_friction m a beta sigma.
Proof.
  intros. unfold dissipated_lower, cycle_friction. rewrite Rabs_Ropp, Rabs_right by lra. field.
Qed.

(** TH-ACTIVE (gain): d (m + 1 - 2 beta d - 2 sigma) with d = m + a. *)
Theorem TH_ACTIVE_gain : forall m a beta sigma,
  cycle_gain m a beta sigma = (m + a) * (m + 1 - 2 * beta * (m + a) - 2 * sigma).
Proof. intros. unfold cycle_gain, cycle_work, cycle_friction. ring. Qed.

Lemma INR_unbounded : forall x, exists N, x < INR N.
Proof.
  intro x. exists (Z.to_nat (up (Rmax x 0))). pose proof (archimed (Rmax x 0)) as [A _].
  pose proof (Rmax_l x 0). pose proof (Rmax_r x 0).
  rewrite INR_IZR_INZ, Z2Nat.id; [lra |]. apply le_IZR. lra.
Qed.

(** With beta, sigma of at least 1/2 no cycle gains. *)
Lemma no_gain : forall (m : nat) a beta sigma, 1 / 2 <= beta -> 1 / 2 <= sigma -> 0 < a <= 1 ->
  cycle_gain (INR m) a beta sigma < 0.
Proof.
  intros m a beta sigma Hb Hs Ha. rewrite TH_ACTIVE_gain. pose proof (pos_INR m).
  assert (INR m + a <= 2 * beta * (INR m + a)) by nra. nra.
Qed.

(** Below sigma = 1/2 a short cycle with m = 0 gains. *)
Lemma gain_small : forall beta sigma, 0 <= beta -> sigma < 1 / 2 ->
  exists N, 0 < cycle_gain 0 (1 / INR (S N)) beta sigma.
Proof.
  intros beta sigma Hb Hs.
  destruct (INR_unbounded (2 * beta / (1 - 2 * sigma))) as (N & HN).
  exists N. rewrite TH_ACTIVE_gain. pose proof (lt_0_INR (S N) ltac:(lia)) as Sp.
  assert (Hn : 2 * beta < INR (S N) * (1 - 2 * sigma)).
  { rewrite S_INR. pose proof (pos_INR N).
    assert (2 * beta / (1 - 2 * sigma) * (1 - 2 * sigma) = 2 * beta) by (field; lra). nra. }
  replace ((0 + 1 / INR (S N)) * (0 + 1 - 2 * beta * (0 + 1 / INR (S N)) - 2 * sigma))
    with ((INR (S N) * (1 - 2 * sigma) - 2 * beta) / (INR (S N) * INR (S N))) by (field; lra).
  apply Rdiv_lt_0_compat; nra.
Qed.

(** Below beta = 1/2 a long cycle with a = 1 gains. *)
Lemma gain_long : forall beta sigma, beta < 1 / 2 ->
  exists m, 0 < cycle_gain (INR m) 1 beta sigma.
Proof.
  intros beta sigma Hb.
  destruct (INR_unbounded (2 * sigma / (1 - 2 * beta))) as (m & Hm).
  exists m. rewrite TH_ACTIVE_gain. pose proof (pos_INR m).
  assert (2 * sigma / (1 - 2 * beta) * (1 - 2 * beta) = 2 * sigma) by (field; lra).
  assert (2 * sigma < (INR m + 1) * (1 - 2 * beta)) by nra. nra.
Qed.

(** TH-ACTIVE: some cycle has positive gain iff beta < 1/2 or sigma < 1/2; then one exists
    with a = 1/N, so for rational friction an exact rational cycle is the witness. *)
Theorem TH_ACTIVE : forall beta sigma, 0 <= beta ->
  (exists m N, 0 < cycle_gain (INR m) (1 / INR (S N)) beta sigma)
  <-> (beta < 1 / 2 \/ sigma < 1 / 2).
Proof.
  intros beta sigma Hb. split.
  - intros (m & N & G). destruct (Rlt_le_dec beta (1 / 2)) as [| B]; [left; assumption |].
    destruct (Rlt_le_dec sigma (1 / 2)) as [| Sg]; [right; assumption | exfalso].
    pose proof (lt_0_INR (S N) ltac:(lia)) as Sp. pose proof (pos_INR N).
    assert (A : 0 < 1 / INR (S N) <= 1).
    { split; [apply Rdiv_lt_0_compat; lra |]. apply Rmult_le_reg_r with (INR (S N)); [exact Sp |].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. rewrite S_INR. lra. }
    pose proof (no_gain m (1 / INR (S N)) beta sigma B Sg A). lra.
  - intros [B | Sg].
    + destruct (gain_long beta sigma B) as (m & G). exists m, 0%nat.
      replace (1 / INR 1) with 1 by (simpl; field). exact G.
    + destruct (gain_small beta sigma Hb Sg) as (N & G). exists 0%nat, N. exact G.
Qed.

(** The same over all cycles: no amplitude a in (0, 1] helps where 1/N does not. *)
Theorem TH_ACTIVE_any_amplitude : forall beta sigma, 0 <= beta ->
  (exists m a, 0 < a <= 1 /\ 0 < cycle_gain (INR m) a beta sigma)
  <-> (beta < 1 / 2 \/ sigma < 1 / 2).
Proof.
  intros beta sigma Hb. split.
  - intros (m & a & A & G). destruct (Rlt_le_dec beta (1 / 2)) as [| B]; [left; assumption |].
    destruct (Rlt_le_dec sigma (1 / 2)) as [| Sg]; [right; assumption | exfalso].
    pose proof (no_gain m a beta sigma B Sg A). lra.
  - intros [B | Sg].
    + destruct (gain_long beta sigma B) as (m & G). exists m, 1. split; [lra | exact G].
    + destruct (gain_small beta sigma Hb Sg) as (N & G). exists 0%nat, (1 / INR (S N)).
      pose proof (lt_0_INR (S N) ltac:(lia)) as Sp. pose proof (pos_INR N). split; [| exact G].
      split; [apply Rdiv_lt_0_compat; lra |]. apply Rmult_le_reg_r with (INR (S N)); [exact Sp |].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. rewrite S_INR. lra.
Qed.

(** TH-SMOOTH (converse): without an encoder the cycle p -> p + d -> p gains
    d^2 - 2 (beta d^2 + sigma d), and some d > 0 makes that positive iff beta < 1/2. *)
Theorem TH_SMOOTH_active : forall beta sigma, 0 <= sigma ->
  (exists d, 0 < d /\ 0 < d ^ 2 - 2 * (beta * d ^ 2 + sigma * d)) <-> beta < 1 / 2.
Proof.
  intros beta sigma Hs. split.
  - intros (d & Hd & G). destruct (Rlt_le_dec beta (1 / 2)) as [L | L]; [exact L | exfalso].
    assert (0 <= sigma * d) by (apply Rmult_le_pos; lra).
    pose proof (pow2_ge_0 d). nra.
  - intro L. set (d := (sigma + 1) / (1 / 2 - beta)).
    assert (E : d * (1 / 2 - beta) = sigma + 1) by (unfold d; field; lra).
    assert (D : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; lra).
    exists d. split; [exact D |].
    replace (d ^ 2 - 2 * (beta * d ^ 2 + sigma * d)) with (2 * d * (d * (1 / 2 - beta) - sigma)) by field.
    rewrite E. nra.
Qed.
