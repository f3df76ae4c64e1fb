(** * Units: from the device (1), (2) in SI units to the dimensionless one (5), (6), and back.

    [obeys] with m, b, c and the instants hT is (1) in integrated form; (3), (4) and (7) change the
    units.  What is proved of dimensionless motions so holds of the device's. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model Law Combined Passivity Region.
Open Scope R_scope.

(** The integral in another unit of time. *)
Lemma is_RInt_in_units : forall (f : R -> R) T a b l, T <> 0 ->
  is_RInt f (T * a) (T * b) l -> is_RInt (fun y => f (T * y)) a b (l / T).
Proof.
  intros f T a b l HT I.
  replace (T * a) with (T * a + 0) in I by ring. replace (T * b) with (T * b + 0) in I by ring.
  apply (@is_RInt_comp_lin R_NormedModule) in I.
  apply (@is_RInt_scal R_NormedModule _ _ _ (/ T)) in I.
  replace (l / T) with (/ T * l) by (unfold Rdiv; ring).
  apply is_RInt_ext with (2 := I). over_R. unfold scal; simpl; unfold mult; simpl.
  rewrite Rplus_0_r. field. exact HT.
Qed.

Lemma RInt_in_units : forall (f : R -> R) T a b, T <> 0 -> ex_RInt f (T * a) (T * b) ->
  RInt (fun y => f (T * y)) a b = RInt f (T * a) (T * b) / T.
Proof.
  intros f T a b HT I. apply is_RInt_unique, is_RInt_in_units; [exact HT | apply RInt_is, I].
Qed.

Section Units.

Variables m b c K T Delta : R.
Hypothesis K_pos : 0 < K.
Hypothesis T_pos : 0 < T.
Hypothesis D_pos : 0 < Delta.

(** (3), (4), and forces over K Delta. *)
Definition xi_of (x : R -> R) (tau : R) : R := x (T * tau) / Delta.
Definition xi_dot_of (v : R -> R) (tau : R) : R := v (T * tau) * T / Delta.
Definition phi_of (F : R -> R) (tau : R) : R := F (T * tau) / (K * Delta).

Lemma in_units_positive : 0 < T / Delta /\ 0 < K * Delta /\ 0 < K * T.
Proof. repeat split; [apply Rdiv_lt_0_compat | nra | nra]; assumption. Qed.

(** EQ-1..7: a motion that obeys (1) under any held forces obeys (6) in units of Delta, T and
    K Delta, with the parameters (7). *)
Theorem EQ_1_7 : forall (ts ts' held : nat -> R) x v friction hand,
  (forall h, ts h = T * ts' h) ->
  (forall h, ts h <= ts (S h)) ->
  obeys m b c ts held x v friction hand ->
  obeys (mu_of m K T) (beta_of b K T) (sigma_of c K Delta) ts' (fun h => held h / (K * Delta))
    (xi_of x) (xi_dot_of v) (phi_of friction) (phi_of hand).
Proof.
  intros ts ts' held x v friction hand Ts Order O.
  destruct in_units_positive as (TD & KD & KT).
  pose proof (is_kinematic _ _ _ _ _ _ _ _ _ O) as Kin.
  assert (Dv : forall F h, ex_RInt F (ts h) (ts (S h)) -> ex_RInt (phi_of F) (ts' h) (ts' (S h))).
  { intros F h (l & I). rewrite !Ts in I. apply is_RInt_in_units in I; [| lra].
    exists (/ (K * Delta) * (l / T)).
    apply is_RInt_ext with (fun y => / (K * Delta) * F (T * y)).
    - over_R. unfold phi_of, Rdiv. ring.
    - apply (@is_RInt_scal R_NormedModule), I. }
  split.
  - split; intro t; unfold xi_of, xi_dot_of.
    + pose proof (velocity_is_derivative _ _ Kin (T * t)) as D.
      auto_derive; [exists (v (T * t)); exact D |].
      change (Derive (fun y => x y) (T * t)) with (Derive x (T * t)).
      rewrite (is_derive_unique _ _ _ D). unfold Rdiv. ring.
    + apply continuous_ext with (fun y => v (T * y) * (T / Delta)); [over_R; unfold Rdiv; ring |].
      apply continuous_Rmult; [| apply continuous_const].
      apply (continuous_comp (fun y => T * y) v); [| apply (velocity_continuous _ _ Kin)].
      apply continuous_Rmult; [apply continuous_const | apply continuous_id].
  - intro t. unfold phi_of, xi_dot_of, sigma_of.
    replace (v (T * t) * T / Delta) with (v (T * t) * (T / Delta)) by (unfold Rdiv; ring).
    rewrite Rabs_mult, (Rabs_right (T / Delta)) by lra.
    replace (friction (T * t) / (K * Delta) * (v (T * t) * (T / Delta)))
      with (friction (T * t) * v (T * t) * (T / Delta / (K * Delta))) by (field; lra).
    rewrite (friction_opposes _ _ _ _ _ _ _ _ _ O). field. lra.
  - intro t. unfold phi_of, sigma_of, Rdiv. rewrite Rabs_mult.
    rewrite (Rabs_right (/ (K * Delta))) by (apply Rle_ge, Rlt_le, Rinv_0_lt_compat, KD).
    apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, KD |].
    apply (friction_bounded _ _ _ _ _ _ _ _ _ O).
  - intro h. apply Dv, (friction_integrable _ _ _ _ _ _ _ _ _ O).
  - intro h. apply Dv, (hand_integrable _ _ _ _ _ _ _ _ _ O).
  - intros h t Ht.
    assert (Range : ts h <= T * t <= ts (S h)).
    { rewrite !Ts. split; apply Rmult_le_compat_l; lra. }
    pose proof (newton _ _ _ _ _ _ _ _ _ O h (T * t) Range) as N.
    set (F := fun u => hand u + held h - b * v u - friction u) in *.
    assert (IF : ex_RInt F (T * ts' h) (T * t)).
    { rewrite <- Ts. apply ex_RInt_part with (ts h) (ts (S h)); [| lra | lra]. unfold F.
      apply (@ex_RInt_minus R_NormedModule); [| apply (friction_integrable _ _ _ _ _ _ _ _ _ O)].
      apply (@ex_RInt_minus R_NormedModule).
      - apply (@ex_RInt_plus R_NormedModule); [apply (hand_integrable _ _ _ _ _ _ _ _ _ O) |].
        apply (@ex_RInt_const R_NormedModule).
      - apply (@ex_RInt_scal R_NormedModule). eexists. apply (vel_integral _ _ Kin). }
    rewrite (RInt_ext _ (fun y => / (K * Delta) * F (T * y))).
    + rewrite (@RInt_scal R_CompleteNormedModule).
      * rewrite RInt_in_units by (try exact IF; lra). rewrite Ts in N at 2. rewrite <- N.
        unfold xi_dot_of, mu_of. rewrite Ts. unfold scal; simpl; unfold mult; simpl; over_R; field; lra.
      * destruct IF as (l & I). apply is_RInt_in_units in I; [| lra]. exists (l / T). exact I.
    + over_R. unfold F, phi_of, xi_dot_of, beta_of. field. lra.
Qed.

(** EQ-5: the held force (2) is (5) in units of K Delta. *)
Theorem EQ_1_7_held : forall x h,
  - (K * Delta * (floor (x (T * INR h) / Delta) + 1 / 2)) / (K * Delta) = held_force (xi_of x (INR h)).
Proof. intros. unfold held_force, measured, xi_of. field. lra. Qed.

(** EQ-1..7 (energy): energies are in units of K Delta^2. *)
Theorem EQ_1_7_energy : forall v hand a z, a <= z ->
  ex_RInt (fun u => hand u * v u) (T * a) (T * z) ->
  operator_energy v hand (T * a) (T * z)
  = K * Delta ^ 2 * operator_energy (xi_dot_of v) (phi_of hand) a z.
Proof.
  intros v hand a z az I.
  assert (J : is_RInt (fun u => phi_of hand u * xi_dot_of v u) a z
    (T / (K * Delta ^ 2) * (operator_energy v hand (T * a) (T * z) / T))).
  { apply is_RInt_ext with (fun y => T / (K * Delta ^ 2) * (hand (T * y) * v (T * y))).
    - over_R. unfold phi_of, xi_dot_of. field. lra.
    - apply (@is_RInt_scal R_NormedModule).
      apply (is_RInt_in_units (fun u => hand u * v u)); [lra | apply RInt_is, I]. }
  unfold operator_energy at 2. rewrite (is_RInt_unique _ _ _ _ J). field. lra.
Qed.

Theorem EQ_1_7_storage : forall x v tau,
  m * v (T * tau) ^ 2 / 2 + K * x (T * tau) ^ 2 / 2
  = K * Delta ^ 2 * storage (mu_of m K T) (xi_of x tau) (xi_dot_of v tau).
Proof.
  intros. unfold storage, kinetic, linear_potential, mu_of, xi_of, xi_dot_of. field. lra.
Qed.

End Units.

(** EQ-1..7 (passivity): a device (1) with the wall (2), in SI units: where (11) holds at each of its
    speeds, the operator puts in at least the growth of m v^2/2 + K x^2/2. *)
Theorem EQ_1_7_run : forall m b c K T Delta x v friction hand,
  0 < m -> 0 <= b -> 0 <= c -> 0 < K -> 0 < T -> 0 < Delta ->
  obeys m b c (fun h => T * INR h)
    (fun h => - (K * Delta * (floor (x (T * INR h) / Delta) + 1 / 2))) x v friction hand ->
  forall t, 0 <= t ->
  (forall u, 0 <= u <= t -> v u <> 0 ->
     0 <= margin (viscous_si b K T 0 0) (coulomb_si c K T Delta 0 0) (Rabs (v u))) ->
  ex_RInt (fun u => hand u * v u) 0 t ->
  m * v t ^ 2 / 2 + K * x t ^ 2 / 2 - (m * v 0 ^ 2 / 2 + K * x 0 ^ 2 / 2)
  <= operator_energy v hand 0 t.
Proof.
  intros m b c K T Delta x v friction hand Hm Hb Hc HK HT HD O t Ht H11 I.
  assert (KT : 0 < K * T) by nra. assert (KD : 0 < K * Delta) by nra.
  assert (P : physical (mu_of m K T) (beta_of b K T) (sigma_of c K Delta)).
  { split; unfold mu_of, beta_of, sigma_of.
    - apply Rdiv_lt_0_compat; [exact Hm | apply Rmult_lt_0_compat; [exact HK | apply pow_lt, HT]].
    - apply Rmult_le_pos; [exact Hb | apply Rlt_le, Rinv_0_lt_compat, KT].
    - apply Rmult_le_pos; [exact Hc | apply Rlt_le, Rinv_0_lt_compat, KD]. }
  assert (Q : paper_motion (mu_of m K T) (beta_of b K T) (sigma_of c K Delta)
    (xi_of T Delta x) (xi_dot_of T Delta v) (phi_of K T Delta friction) (phi_of K T Delta hand)).
  { unfold paper_motion.
    assert (Order : forall h, T * INR h <= T * INR (S h))
      by (intro h; apply Rmult_le_compat_l; [lra | rewrite S_INR; lra]).
    pose proof (EQ_1_7 m b c K T Delta HK HT HD _ INR _ x v friction hand
      (fun h => eq_refl) Order O) as E.
    destruct E as [E1 E2 E3 E4 E5 E6]. split; try assumption.
    intros h u Hu. rewrite (E6 h u Hu). apply RInt_ext. intros y _.
    rewrite <- (EQ_1_7_held K T Delta HK HD x h). reflexivity. }
  set (tau := t / T). assert (Et : T * tau = t) by (unfold tau; field; lra).
  assert (Ht' : 0 <= tau) by (apply Rmult_le_pos; [exact Ht | apply Rlt_le, Rinv_0_lt_compat, HT]).
  destruct (TH_RUN _ _ _ _ _ _ _ P Q tau Ht') as [_ R].
  - intros u Hu Hv. rewrite <- Et in H11.
    assert (Range : 0 <= T * u <= T * tau) by (split; [nra | apply Rmult_le_compat_l; lra]).
    unfold xi_dot_of in *.
    assert (Hv0 : v (T * u) <> 0) by (intro Z; apply Hv; rewrite Z; unfold Rdiv; ring).
    specialize (H11 _ Range Hv0). apply EQ_8_margin; [exact Hv |].
    rewrite (EQ_11 b c K T Delta (Rabs (v (T * u))) 0 0 0 HK HT HD) in H11.
    destruct (in_units_positive K T Delta HK HT HD) as (TD & _).
    replace (v (T * u) * T / Delta) with (v (T * u) * (T / Delta)) by (unfold Rdiv; ring).
    rewrite Rabs_mult, (Rabs_right (T / Delta)) by lra.
    replace (0 / (K * T)) with 0 in H11 by (field; lra).
    replace (0 / (K * Delta)) with 0 in H11 by (field; lra).
    replace (Rabs (v (T * u)) * T / Delta) with (Rabs (v (T * u)) * (T / Delta)) in H11
      by (unfold Rdiv; ring).
    apply Rmult_le_reg_l with (K * Delta); [exact KD | lra].
  - pose proof (EQ_1_7_energy K T Delta HK HT HD v hand 0 tau Ht') as E.
    rewrite Et, Rmult_0_r in E. rewrite (E I).
    pose proof (EQ_1_7_storage m K T Delta HK HT HD x v tau) as S1.
    pose proof (EQ_1_7_storage m K T Delta HK HT HD x v 0) as S0.
    rewrite Et in S1. rewrite Rmult_0_r in S0. rewrite S1, S0.
    assert (U : 0 < K * Delta ^ 2) by (apply Rmult_lt_0_compat; [exact HK | apply pow_lt, HD]).
    rewrite <- Rmult_minus_distr_l. apply Rmult_le_compat_l; [lra | exact R].
Qed.
