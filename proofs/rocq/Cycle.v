(** * Cycle: the smooth witness cycle as a motion of a device whose force is held from sample to sample.

    Up on even intervals, down on odd ones, between [low] and [low + d]. *)

From Coq Require Import Reals Lra Lia Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model Law Combined Passivity
  Glue Leg.
Open Scope R_scope.

Section Cycle.

Variables mu beta sigma : R.
(** The force that is held from a position at a sample. *)
Variable force : R -> R.
Variables low d : R.
Variable k : nat.
Hypothesis P : physical mu beta sigma.
Hypothesis d_pos : 0 < d.

Definition way (z : Z) : R := if Z.even z then 1 else -1.
Definition base (z : Z) : R := if Z.even z then low else low + d.

Definition pos_piece (z : Z) (t : R) : R := base z + way z * d * leg k (t - IZR z).
Definition vel_piece (z : Z) (t : R) : R := way z * d * dleg k (t - IZR z).
Definition acc_piece (z : Z) (t : R) : R := way z * d * ddleg k (t - IZR z).
Definition hand_piece (z : Z) (t : R) : R :=
  mu * acc_piece z t + beta * vel_piece z t + sigma * way z - force (base z).

Definition cpos : R -> R := glued pos_piece.
Definition cvel : R -> R := glued vel_piece.
Definition chand : R -> R := glued hand_piece.
Definition cfriction : R -> R := glued (fun z _ => sigma * way z).

Lemma way_cases : forall z, (way z = 1 /\ way (z + 1) = -1 /\ base z = low /\ base (z + 1) = low + d) \/
  (way z = -1 /\ way (z + 1) = 1 /\ base z = low + d /\ base (z + 1) = low).
Proof.
  intro z. unfold way, base. rewrite Z.even_add. destruct (Z.even z); [left | right]; auto.
Qed.

Lemma shifted : forall (f df : R -> R) c z t, (forall r, is_derive f r (df r)) ->
  is_derive (fun t => c * f (t - IZR z)) t (c * df (t - IZR z)).
Proof.
  intros f df c z t D. apply is_derive_scal. evar_last.
  { apply (is_derive_comp f (fun t => t - IZR z)); [apply D |].
    apply (@is_derive_minus R_AbsRing R_NormedModule); [apply is_derive_id | apply is_derive_const]. }
  unfold scal, minus, plus, opp, zero, one; simpl. unfold mult; simpl. ring.
Qed.

Lemma pos_piece_derive : forall z t, is_derive (pos_piece z) t (vel_piece z t).
Proof.
  intros z t. unfold pos_piece, vel_piece. evar_last.
  { apply (@is_derive_plus R_AbsRing R_NormedModule (fun _ => base z)); [apply is_derive_const |].
    apply shifted, leg_derive. }
  unfold plus, zero; simpl. ring.
Qed.

Lemma vel_piece_derive : forall z t, is_derive (vel_piece z) t (acc_piece z t).
Proof. intros. apply shifted, dleg_derive. Qed.

Lemma vel_piece_continuous : forall z t, continuous (vel_piece z) t.
Proof. intros. apply (ex_derive_continuous (vel_piece z)). eexists. apply vel_piece_derive. Qed.

Lemma acc_piece_continuous : forall z t, continuous (acc_piece z) t.
Proof.
  intros z t. unfold acc_piece. apply continuous_Rmult; [apply continuous_const |].
  apply (continuous_comp (fun t => t - IZR z) (ddleg k)); [| apply ddleg_continuous].
  apply (@continuous_minus _ R_AbsRing R_NormedModule); [apply continuous_id | apply continuous_const].
Qed.

Lemma at_ends : forall z t, (t = IZR z \/ t = IZR z + 1) ->
  vel_piece z t = 0 /\ pos_piece z t = base z + (t - IZR z) * (way z * d).
Proof.
  intros z t H. destruct (leg_ends k) as (L0 & L1 & D0 & D1). unfold vel_piece, pos_piece.
  destruct H as [-> | ->].
  - replace (IZR z - IZR z) with 0 by ring. rewrite L0, D0. split; ring.
  - replace (IZR z + 1 - IZR z) with 1 by ring. rewrite L1, D1. split; ring.
Qed.

Lemma pos_meets : forall z, pos_piece z (IZR z + 1) = pos_piece (z + 1) (IZR z + 1).
Proof.
  intro z. destruct (at_ends z (IZR z + 1)) as [_ ->]; [auto |].
  destruct (at_ends (z + 1) (IZR z + 1)) as [_ ->]; [left; rewrite plus_IZR; ring |].
  rewrite plus_IZR. destruct (way_cases z) as [(-> & -> & -> & ->) | (-> & -> & -> & ->)]; ring.
Qed.

Lemma vel_meets : forall z, vel_piece z (IZR z + 1) = vel_piece (z + 1) (IZR z + 1).
Proof.
  intro z. destruct (at_ends z (IZR z + 1)) as [-> _]; [auto |].
  destruct (at_ends (z + 1) (IZR z + 1)) as [-> _]; [left; rewrite plus_IZR; ring | reflexivity].
Qed.

Lemma cycle_kinematic : kinematic cpos cvel.
Proof.
  split.
  - apply (glued_derive pos_piece pos_meets vel_piece pos_piece_derive vel_meets).
  - apply (glued_continuous vel_piece vel_meets vel_piece_continuous).
Qed.

Lemma cpos_at : forall z, cpos (IZR z) = base z.
Proof.
  intro z. unfold cpos. rewrite (glued_on pos_piece z) by lra.
  destruct (at_ends z (IZR z)) as [_ ->]; [auto | ring].
Qed.

Lemma cvel_at : forall z, cvel (IZR z) = 0.
Proof.
  intro z. unfold cvel. rewrite (glued_on vel_piece z) by lra. apply at_ends. auto.
Qed.

Lemma way_square : forall z, way z * way z = 1.
Proof. intro z. unfold way. destruct (Z.even z); ring. Qed.

Lemma speed_piece : forall z t, IZR z <= t <= IZR z + 1 ->
  Rabs (vel_piece z t) = way z * vel_piece z t.
Proof.
  intros z t Ht. pose proof (dleg_nonneg k (t - IZR z) ltac:(lra)) as N.
  assert (M : 0 <= d * dleg k (t - IZR z)) by (apply Rmult_le_pos; lra).
  unfold vel_piece, way. destruct (Z.even z).
  - rewrite Rabs_right; [ring | lra].
  - rewrite Rabs_left1; [ring | lra].
Qed.

(** The cycle is a motion of the device, driven by the operator's force [chand]. *)
Lemma cycle_obeys :
  obeys mu beta sigma INR (fun h => force (cpos (INR h))) cpos cvel cfriction chand.
Proof.
  pose proof (mu_positive _ _ _ P). pose proof (sigma_nonneg _ _ _ P).
  assert (IS : forall h, INR (S h) = IZR (Z.of_nat h) + 1).
  { intro h. rewrite S_INR, INR_IZR_INZ. reflexivity. }
  assert (On : forall f h t u, INR h <= t <= INR (S h) -> Rmin (INR h) t < u < Rmax (INR h) t ->
             glued f u = f (Z.of_nat h) u).
  { intros f h t u Ht Hu. rewrite Rmin_left, Rmax_right in Hu by lra. apply glued_on.
    rewrite <- INR_IZR_INZ. rewrite IS, <- INR_IZR_INZ in Ht. lra. }
  assert (Full : forall h, INR h <= INR (S h) <= INR (S h)) by (intro h; rewrite S_INR; lra).
  split.
  - exact cycle_kinematic.
  - intro t. unfold cfriction, cvel, glued. set (z := Int_part t).
    pose proof (Int_part_spec t) as S. fold z in S. rewrite (speed_piece z t) by lra. ring.
  - intro t. unfold cfriction, glued, way. destruct (Z.even (Int_part t)).
    + rewrite Rmult_1_r, Rabs_right; lra.
    + rewrite Rabs_left1; lra.
  - intro h. apply ex_RInt_ext with (fun _ => sigma * way (Z.of_nat h)).
    + intros u Hu. symmetry. apply (On (fun z _ => sigma * way z) h (INR (S h)) u (Full h) Hu).
    + apply (@ex_RInt_const R_NormedModule).
  - intro h. apply ex_RInt_ext with (hand_piece (Z.of_nat h)).
    + intros u Hu. symmetry. apply (On hand_piece h (INR (S h)) u (Full h) Hu).
    + apply ex_RInt_cont. intro u. unfold hand_piece, Rminus.
      apply continuous_Rplus; [| apply continuous_const].
      apply continuous_Rplus; [| apply continuous_const].
      apply continuous_Rplus; (apply continuous_Rmult; [apply continuous_const |]);
        [apply acc_piece_continuous | apply vel_piece_continuous].
  - intros h t Ht. set (z := Z.of_nat h) in *.
    rewrite (RInt_ext _ (fun u => mu * acc_piece z u)).
    + rewrite (@RInt_scal R_CompleteNormedModule)
        by (apply ex_RInt_cont, acc_piece_continuous).
      rewrite (RInt_primitive (vel_piece z) (acc_piece z))
        by (intros; apply vel_piece_derive || apply acc_piece_continuous).
      unfold cvel. rewrite !(glued_on_closed vel_piece vel_meets z)
        by (unfold z; rewrite <- IS, <- INR_IZR_INZ; lra).
      reflexivity.
    + intros u Hu. unfold chand, cvel, cfriction. rewrite !(On _ h t u Ht Hu). fold z.
      unfold hand_piece. rewrite INR_IZR_INZ. fold z. rewrite cpos_at. over_R. ring.
Qed.

(** What a leg costs the operator's opponent, friction: a little more than at constant speed. *)
Lemma leg_dissipated : forall h,
  dissipated beta sigma cvel (INR h) (INR (S h))
  = beta * d ^ 2 * (1 + / (4 * INR (S k) + 1)) + sigma * d.
Proof.
  intro h. unfold dissipated. rewrite S_INR, (INR_IZR_INZ h). set (z := Z.of_nat h).
  rewrite (RInt_ext _ (fun u => beta * d ^ 2 * dleg k (u - IZR z) ^ 2 + sigma * d * dleg k (u - IZR z))).
  - rewrite (RInt_primitive (fun u => beta * d ^ 2 * qleg k (u - IZR z) + sigma * d * leg k (u - IZR z))).
    + replace (IZR z + 1 - IZR z) with 1 by ring. replace (IZR z - IZR z) with 0 by ring.
      destruct (leg_ends k) as (-> & -> & _). rewrite <- (qleg_ends k). ring.
    + intro u. apply (@is_derive_plus R_AbsRing R_NormedModule
        (fun u => beta * d ^ 2 * qleg k (u - IZR z)) (fun u => sigma * d * leg k (u - IZR z))).
      * apply (shifted (qleg k) (fun r => dleg k r ^ 2)), qleg_derive.
      * apply shifted, leg_derive.
    + intro u. assert (C : continuous (fun u => dleg k (u - IZR z)) u).
      { apply (continuous_comp (fun t => t - IZR z) (dleg k)).
        - apply (@continuous_minus _ R_AbsRing R_NormedModule);
            [apply continuous_id | apply continuous_const].
        - apply (ex_derive_continuous (dleg k)). eexists. apply dleg_derive. }
      apply continuous_Rplus; (apply continuous_Rmult; [apply continuous_const |]); [| exact C].
      simpl. apply continuous_Rmult; [exact C |].
      apply continuous_Rmult; [exact C | apply continuous_const].
  - intros u Hu. rewrite Rmin_left, Rmax_right in Hu by lra.
    unfold cvel. rewrite (glued_on vel_piece z) by lra. unfold friction_power.
    rewrite speed_piece by lra. unfold vel_piece. over_R.
    replace (way z * (way z * d * dleg k (u - IZR z))) with (d * dleg k (u - IZR z))
      by (rewrite <- Rmult_assoc, <- Rmult_assoc, way_square; ring).
    replace ((way z * d * dleg k (u - IZR z)) ^ 2) with (d ^ 2 * dleg k (u - IZR z) ^ 2); [ring |].
    replace ((way z * d * dleg k (u - IZR z)) ^ 2)
      with (way z * way z * (d ^ 2 * dleg k (u - IZR z) ^ 2)) by ring.
    rewrite way_square. ring.
Qed.

Lemma leg_operator : forall h,
  is_RInt (fun u => chand u * cvel u) (INR h) (INR (S h))
    (- force (base (Z.of_nat h)) * (way (Z.of_nat h) * d)
     + (beta * d ^ 2 * (1 + / (4 * INR (S k) + 1)) + sigma * d)).
Proof.
  intro h.
  pose proof (EQ_6_energy mu beta sigma INR _ cpos cvel cfriction chand P cycle_obeys h (INR (S h))
    ltac:(rewrite S_INR; lra)) as E.
  rewrite leg_dissipated in E. rewrite INR_IZR_INZ, !cvel_at, S_INR, INR_IZR_INZ, cpos_at in E.
  replace (IZR (Z.of_nat h) + 1) with (IZR (Z.of_nat h + 1)) in * by (rewrite plus_IZR; reflexivity).
  rewrite cpos_at, cvel_at in E.
  rewrite S_INR, INR_IZR_INZ. rewrite <- (plus_IZR _ 1).
  replace (- force (base (Z.of_nat h)) * (way (Z.of_nat h) * d)
     + (beta * d ^ 2 * (1 + / (4 * INR (S k) + 1)) + sigma * d)) with
   (kinetic mu 0 - kinetic mu 0 - force (base (Z.of_nat h)) * (base (Z.of_nat h + 1) - base (Z.of_nat h))
     + (beta * d ^ 2 * (1 + / (4 * INR (S k) + 1)) + sigma * d)); [exact E |].
  destruct (way_cases (Z.of_nat h)) as [(-> & _ & -> & ->) | (-> & _ & -> & ->)]; ring.
Qed.

(** What the operator draws in n cycles. *)
Definition drawn_per_cycle : R :=
  force low * d - force (low + d) * d
  - 2 * (beta * d ^ 2 * (1 + / (4 * INR (S k) + 1)) + sigma * d).

Lemma cycles_operator : forall n,
  is_RInt (fun u => chand u * cvel u) 0 (INR (2 * n)) (- (INR n * drawn_per_cycle)).
Proof.
  induction n as [| n IH].
  - simpl (INR 0). replace (- (0 * drawn_per_cycle)) with 0 by ring.
    replace (INR (2 * 0)) with 0 by reflexivity. apply (@is_RInt_point R_NormedModule).
  - replace (2 * S n)%nat with (S (S (2 * n))) by lia.
    pose proof (leg_operator (2 * n)) as U. pose proof (leg_operator (S (2 * n))) as D.
    assert (Ev : Z.even (Z.of_nat (2 * n)) = true)
      by (rewrite Nat2Z.inj_mul; apply Z.even_mul).
    assert (Od : Z.even (Z.of_nat (S (2 * n))) = false).
    { rewrite Nat2Z.inj_succ, Z.even_succ, <- Z.negb_even, Ev. reflexivity. }
    unfold way, base in U, D. rewrite Ev in U. rewrite Od in D.
    replace (- (INR (S n) * drawn_per_cycle))
      with (- (INR n * drawn_per_cycle)
            + (- force low * (1 * d) + (beta * d ^ 2 * (1 + / (4 * INR (S k) + 1)) + sigma * d))
            + (- force (low + d) * (-1 * d) + (beta * d ^ 2 * (1 + / (4 * INR (S k) + 1)) + sigma * d))).
    + apply is_RInt_join with (INR (S (2 * n))); [apply is_RInt_join with (INR (2 * n)) |]; assumption.
    + rewrite (S_INR n). unfold drawn_per_cycle. ring.
Qed.

End Cycle.
