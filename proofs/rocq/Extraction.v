(** * Extraction: TH-ACTIVE, and TH-SMOOTH's converse, as motions of the model.

    The witness cycle turns at its ends, so at constant speed it would need infinite force.
    Here the velocity of each leg is the smooth profile d c (1 - (2r - 1)^(2p)), r the time
    within the interval; as p grows its friction tends to that of constant speed.  So
    where a cycle gains, a motion of (6) exists from which the operator draws without
    bound, and the criterion at all speeds is necessary as well as sufficient. *)

From Coq Require Import Reals Lra Lia Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model Law Combined Passivity
  Effects Active Glue Leg Cycle.
Open Scope R_scope.

(** A cycle that gains at constant speeds gains as a motion, however often it is repeated. *)
Lemma drawn_without_bound : forall mu beta sigma force low d, physical mu beta sigma -> 0 < d ->
  0 < force low * d - force (low + d) * d - 2 * (beta * d ^ 2 + sigma * d) ->
  exists k, forall E, exists t, 0 <= t /\
    E < - operator_energy (cvel d k) (chand mu beta sigma force low d k) 0 t.
Proof.
  intros mu beta sigma force low d P D G. pose proof (beta_nonneg _ _ _ P) as Hb.
  set (g := force low * d - force (low + d) * d - 2 * (beta * d ^ 2 + sigma * d)) in *.
  destruct (INR_unbounded (beta * d ^ 2 / g)) as (k & Hk).
  assert (X : beta * d ^ 2 * / (4 * INR (S k) + 1) <= g / 4).
  { rewrite S_INR. pose proof (pos_INR k).
    assert (F : beta * d ^ 2 / g * g = beta * d ^ 2) by (field; lra).
    assert (beta * d ^ 2 <= INR k * g) by nra.
    apply Rmult_le_reg_r with (4 * (INR k + 1) + 1); [lra |].
    rewrite Rmult_assoc, Rinv_l by lra. nra. }
  assert (W : g / 2 <= drawn_per_cycle beta sigma force low d k).
  { unfold drawn_per_cycle. set (x := / (4 * INR (S k) + 1)) in *. unfold g in *. lra. }
  exists k. intro E. destruct (INR_unbounded (E / (g / 2))) as (n & Hn).
  exists (INR (2 * n)). split; [apply pos_INR |].
  unfold operator_energy.
  rewrite (is_RInt_unique _ _ _ _ (cycles_operator mu beta sigma force low d k P D n)).
  rewrite Ropp_involutive. pose proof (pos_INR n).
  assert (F : E / (g / 2) * (g / 2) = E) by (field; lra).
  assert (E < INR n * (g / 2)) by nra. nra.
Qed.

(** TH-ACTIVE (motions): below beta = 1/2 or sigma = 1/2 there is, for any mass, a motion of
    the paper's device from which the operator draws more than any given energy.  Its
    samples can be kept inside a wall on one side only. *)
Theorem TH_ACTIVE_motion : forall mu beta sigma, physical mu beta sigma ->
  (beta < 1 / 2 \/ sigma < 1 / 2) ->
  exists pos vel friction hand, paper_motion mu beta sigma pos vel friction hand /\
    (forall h, 0 <= pos (INR h)) /\
    forall E, exists t, 0 <= t /\ E < - operator_energy vel hand 0 t.
Proof.
  intros mu beta sigma P H. pose proof (beta_nonneg _ _ _ P) as Hb.
  apply (proj2 (TH_ACTIVE beta sigma Hb)) in H. destruct H as (m & N & G).
  set (a := 1 / INR (S N)) in *.
  assert (A : 0 < a <= 1).
  { pose proof (lt_0_INR (S N) ltac:(lia)) as Sp. pose proof (pos_INR N). unfold a.
    split; [apply Rdiv_lt_0_compat; lra |]. apply Rmult_le_reg_r with (INR (S N)); [exact Sp |].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. rewrite S_INR. lra. }
  pose proof (pos_INR m) as Hm. set (d := INR m + a). assert (D : 0 < d) by (unfold d; lra).
  set (low := IZR 1 - a).
  assert (W : 0 < held_force low * d - held_force (low + d) * d - 2 * (beta * d ^ 2 + sigma * d)).
  { pose proof (TH_ACTIVE_work 1 m a A) as Wk. cbv zeta in Wk. fold low in Wk.
    replace (IZR 1 + INR m) with (low + d) in Wk by (unfold low, d; ring).
    unfold cycle_gain, cycle_friction in G. fold d in G. lra. }
  destruct (drawn_without_bound mu beta sigma held_force low d P D W) as (k & U).
  exists (cpos low d k), (cvel d k), (cfriction sigma), (chand mu beta sigma held_force low d k).
  split; [exact (cycle_obeys mu beta sigma held_force low d k P D) |]. split; [| exact U].
  intro h. rewrite INR_IZR_INZ, cpos_at. unfold base, low.
  destruct (Z.even (Z.of_nat h)); lra.
Qed.

(** TH-ACTIVE with TH-UNI: the same for the wall on one side. *)
Theorem TH_ACTIVE_motion_unilateral : forall mu beta sigma, physical mu beta sigma ->
  (beta < 1 / 2 \/ sigma < 1 / 2) ->
  exists pos vel friction hand,
    obeys mu beta sigma INR (fun h => - clipped_below 0 (measured (pos (INR h))))
          pos vel friction hand /\
    forall E, exists t, 0 <= t /\ E < - operator_energy vel hand 0 t.
Proof.
  intros mu beta sigma P H.
  destruct (TH_ACTIVE_motion mu beta sigma P H) as (pos & vel & fr & hand & O & In & U).
  exists pos, vel, fr, hand. split; [| exact U].
  destruct O as [K F1 F2 F3 F4 Nw]. split; try assumption.
  intros h t Ht. rewrite (Nw h t Ht). unfold held_force, clipped_below.
  rewrite (Rmax_left (measured (pos (INR h))) 0); [reflexivity |].
  unfold measured. pose proof (floor_monotone 0 (pos (INR h)) (In h)) as Fm.
  rewrite (floor_IZR 0) in Fm. lra.
Qed.

(** TH-ACTIVE (iff): from sampling instants the display is passive for every operator iff
    beta and sigma are both at least 1/2. *)
Theorem TH_ACTIVE_iff : forall mu beta sigma, physical mu beta sigma ->
  ((forall pos vel friction hand, paper_motion mu beta sigma pos vel friction hand ->
      forall t, 0 <= t -> - operator_energy vel hand 0 t <= storage mu (pos 0) (vel 0))
   <-> 1 / 2 <= beta /\ 1 / 2 <= sigma).
Proof.
  intros mu beta sigma P. split.
  - intro H. assert (N : ~ (beta < 1 / 2 \/ sigma < 1 / 2)); [| lra].
    intro C. destruct (TH_ACTIVE_motion mu beta sigma P C) as (pos & vel & fr & hand & O & _ & U).
    destruct (U (storage mu (pos 0) (vel 0))) as (t & Ht & Hu).
    specialize (H pos vel fr hand O t Ht). lra.
  - intros [Hb Hs] pos vel friction hand O t Ht.
    exact (TH_RUN_all_speeds mu beta sigma pos vel friction hand P O Hb Hs t Ht).
Qed.

(** TH-SMOOTH (motions): without an encoder there is, below beta = 1/2 and whatever sigma is, a motion from
    which the operator draws more than any given energy. *)
Theorem TH_SMOOTH_motion : forall mu beta sigma, physical mu beta sigma -> beta < 1 / 2 ->
  exists pos vel friction hand,
    obeys mu beta sigma INR (fun h => - pos (INR h)) pos vel friction hand /\
    (forall h, 0 <= pos (INR h)) /\
    forall E, exists t, 0 <= t /\ E < - operator_energy vel hand 0 t.
Proof.
  intros mu beta sigma P B.
  destruct (proj2 (TH_SMOOTH_active beta sigma (sigma_nonneg _ _ _ P)) B) as (d & D & G).
  assert (W : 0 < - 0 * d - - (0 + d) * d - 2 * (beta * d ^ 2 + sigma * d)) by lra.
  destruct (drawn_without_bound mu beta sigma Ropp 0 d P D W) as (k & U).
  exists (cpos 0 d k), (cvel d k), (cfriction sigma), (chand mu beta sigma Ropp 0 d k).
  split; [exact (cycle_obeys mu beta sigma Ropp 0 d k P D) |]. split; [| exact U].
  intro h. rewrite INR_IZR_INZ, cpos_at. unfold base. destruct (Z.even (Z.of_nat h)); lra.
Qed.

(** TH-SMOOTH (iff): without an encoder the display is passive for every operator iff beta is at least
    1/2, whatever sigma is. *)
Theorem TH_SMOOTH_iff : forall mu beta sigma, physical mu beta sigma ->
  ((forall pos vel friction hand,
      obeys mu beta sigma INR (fun h => - pos (INR h)) pos vel friction hand ->
      forall t, 0 <= t -> - operator_energy vel hand 0 t <= storage mu (pos 0) (vel 0))
   <-> 1 / 2 <= beta).
Proof.
  intros mu beta sigma P. split.
  - intro H. destruct (Rlt_le_dec beta (1 / 2)) as [B | B]; [exfalso | exact B].
    destruct (TH_SMOOTH_motion mu beta sigma P B) as (pos & vel & fr & hand & O & _ & U).
    destruct (U (storage mu (pos 0) (vel 0))) as (t & Ht & Hu).
    specialize (H pos vel fr hand O t Ht). lra.
  - intros B pos vel friction hand O t Ht.
    destruct (TH_SMOOTH mu beta sigma pos vel friction hand (fun _ => 0) P O t Ht) as [_ E].
    + intros u _ Hv. unfold margin_8. pose proof (sigma_nonneg _ _ _ P).
      assert (0 <= sigma / Rabs (vel u)); [| lra].
      apply Rdiv_le_0_compat; [lra | apply Rabs_pos_lt; exact Hv].
    + pose proof (storage_nonneg mu (pos t) (vel t) (mu_positive _ _ _ P)). lra.
Qed.
