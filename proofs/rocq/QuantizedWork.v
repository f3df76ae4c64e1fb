(** * Quantized work: (16) and (18) as integrals along any motion.

    The quantized spring's force jumps whenever the motion crosses a tick, and a motion may
    do so infinitely often in an interval (about a point of rest).  Still the integral of
    force times velocity exists, and is the change of H_e. *)

From Coq Require Import Reals Lra Lia Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Generation Calculus Model Start.
Open Scope R_scope.

(** H_e is linear on each tick, ends included. *)
Lemma quantized_potential_linear : forall z x, IZR z <= x <= IZR z + 1 ->
  quantized_potential x = IZR z ^ 2 / 2 + (IZR z + 1 / 2) * (x - IZR z).
Proof.
  intros z x H. unfold quantized_potential, linear_potential, quantization_potential, residue.
  destruct (Req_dec x (IZR z + 1)) as [E | E].
  - rewrite E, <- plus_IZR, floor_IZR, plus_IZR. field.
  - rewrite (floor_unique x z) by lra. field.
Qed.

(** Between [s] and [t] the motion stays on the tick [z], its ends included. *)
Definition on_tick (pos : R -> R) (z : Z) (s t : R) : Prop :=
  (forall x, Rmin s t < x < Rmax s t -> floor (pos x) = IZR z) /\
  IZR z <= pos s <= IZR z + 1 /\ IZR z <= pos t <= IZR z + 1.

(** Soft threshold: continuous, at most [eps] from its argument, 0 on small arguments. *)
Definition shrink (eps v : R) : R := v - (Rabs (v + eps) - Rabs (v - eps)) / 2.

Lemma shrink_near : forall eps v, 0 < eps -> Rabs (shrink eps v - v) <= eps.
Proof.
  intros eps v H. unfold shrink, Rabs. repeat destruct Rcase_abs; lra.
Qed.

Lemma shrink_small : forall eps v, Rabs v <= eps -> shrink eps v = 0.
Proof.
  intros eps v H. apply Rabs_le_between in H. unfold shrink, Rabs.
  repeat destruct Rcase_abs; lra.
Qed.

Lemma shrink_continuous : forall eps (f : R -> R) x, continuous f x ->
  continuous (fun t => shrink eps (f t)) x.
Proof.
  intros eps f x C. unfold shrink, Rminus, Rdiv.
  assert (S : forall c, continuous (fun t => Rabs (f t + c)) x).
  { intro c. apply continuous_Rabs, continuous_Rplus; [exact C | apply continuous_const]. }
  apply continuous_Rplus; [exact C |]. apply (@continuous_opp _ R_AbsRing R_NormedModule).
  apply continuous_Rmult; [| apply continuous_const].
  apply continuous_Rplus; [apply S | apply (@continuous_opp _ R_AbsRing R_NormedModule), S].
Qed.

(** A function that is integrable once its small values are cut off is integrable. *)
Lemma integrable_by_shrinking : forall (f : R -> R) a b,
  (forall eps, 0 < eps -> ex_RInt (fun t => shrink eps (f t)) a b) -> ex_RInt f a b.
Proof.
  intros f a b H.
  assert (Pos : forall n, 0 < / INR (S n)) by (intro; apply Rinv_0_lt_compat, lt_0_INR; lia).
  destruct (@filterlim_RInt nat R_CompleteNormedModule
    (fun n t => shrink (/ INR (S n)) (f t)) a b eventually _ f
    (fun n => RInt (fun t => shrink (/ INR (S n)) (f t)) a b)) as (I & _ & HI).
  - intro n. apply RInt_is, H, Pos.
  - intros Q (eps & HQ). destruct (nfloor_ex (/ eps)) as (N & _ & HN).
    { apply Rlt_le, Rinv_0_lt_compat, cond_pos. }
    exists N. intros n Hn. apply HQ. intro t.
    apply Rle_lt_trans with (/ INR (S n)); [apply shrink_near, Pos |].
    rewrite <- (Rinv_inv eps).
    assert (INR N + 1 <= INR (S n)) by (rewrite <- S_INR; apply le_INR; lia).
    apply Rinv_lt_contravar; [| lra]. apply Rmult_lt_0_compat; [apply Rinv_0_lt_compat, cond_pos |].
    apply lt_0_INR. lia.
  - exists I. exact HI.
Qed.

(** What is integrable near every instant is integrable over any interval. *)
Lemma integrable_locally : forall f : R -> R,
  (forall x, exists r, 0 < r /\ forall u, Rabs (u - x) < r -> ex_RInt f x u) ->
  forall a b, a <= b -> ex_RInt f a b.
Proof.
  intros f H a b ab.
  apply (time_induction (fun s => ex_RInt f a s) a b ab); [| | | | lra].
  - intro s. apply classic.
  - apply (@ex_RInt_point R_NormedModule).
  - intros s Hs Hall. destruct (H s) as (r & Hr & Hloc). exists r. split; [exact Hr |].
    intros u Hu _. apply (@ex_RInt_Chasles R_NormedModule) with s; [apply Hall; lra |].
    apply Hloc, Rabs_def1; lra.
  - intros s Hs Hall. destruct (H s) as (r & Hr & Hloc).
    set (u := s - Rmin (r / 2) (s - a)).
    assert (0 < Rmin (r / 2) (s - a)) by (apply Rmin_glb_lt; lra).
    pose proof (Rmin_l (r / 2) (s - a)). pose proof (Rmin_r (r / 2) (s - a)).
    apply (@ex_RInt_Chasles R_NormedModule) with u; [apply Hall; unfold u; lra |].
    apply (@ex_RInt_swap R_NormedModule), Hloc. unfold u. apply Rabs_def1; lra.
Qed.

Section Along.

Variables pos vel : R -> R.
Hypothesis K : kinematic pos vel.

Definition work (u : R) : R := measured (pos u) * vel u.

Lemma work_on_tick : forall z s t, on_tick pos z s t ->
  is_RInt work s t (quantized_potential (pos t) - quantized_potential (pos s)).
Proof.
  intros z s t (F & Hs & Ht).
  rewrite (quantized_potential_linear z (pos t) Ht), (quantized_potential_linear z (pos s) Hs).
  replace (_ - _) with ((IZR z + 1 / 2) * (pos t - pos s)) by field.
  apply is_RInt_ext with (fun u => (IZR z + 1 / 2) * vel u).
  - intros x Hx. unfold work, measured. rewrite (F x Hx). reflexivity.
  - apply (@is_RInt_scal R_NormedModule), (vel_integral _ _ K).
Qed.

Lemma shrunk_on_tick : forall eps z s t, on_tick pos z s t ->
  ex_RInt (fun u => shrink eps (work u)) s t.
Proof.
  intros eps z s t (F & _ & _).
  apply ex_RInt_ext with (fun u => shrink eps ((IZR z + 1 / 2) * vel u)).
  - intros x Hx. unfold work, measured. rewrite (F x Hx). reflexivity.
  - apply ex_RInt_cont. intro u. apply shrink_continuous, continuous_Rmult;
      [apply continuous_const | apply (velocity_continuous _ _ K)].
Qed.

(** Near an instant off the tick edges, or on one but moving, each side is on one tick. *)
Lemma regular : forall x, floor (pos x) <> pos x \/ vel x <> 0 ->
  exists r, 0 < r /\ forall u, Rabs (u - x) < r -> exists z, on_tick pos z x u.
Proof.
  intros x Hx. pose proof (floor_spec (pos x)) as Fx.
  destruct (floor_integer (pos x)) as [z Hz]. rewrite Hz in *.
  assert (Between : forall r u y, Rabs (u - x) < r -> Rmin x u < y < Rmax x u -> Rabs (y - x) < r).
  { intros r u y Hu Hy. apply Rabs_def2 in Hu. apply Rabs_def1; unfold Rmin, Rmax in Hy;
      destruct (Rle_dec x u); lra. }
  destruct (Req_dec (IZR z) (pos x)) as [E | E].
  - assert (Hv : vel x <> 0) by (destruct Hx; [contradiction | assumption]).
    destruct (continuous_near pos x 1 (pos_continuous _ _ K x)) as (r1 & R1 & N1); [lra |].
    destruct (continuous_near vel x (Rabs (vel x)) (velocity_continuous _ _ K x)) as (r2 & R2 & N2);
      [apply Rabs_pos_lt, Hv |].
    exists (Rmin r1 r2). split; [apply Rmin_glb_lt; assumption |].
    assert (Close : forall y, Rabs (y - x) < Rmin r1 r2 ->
      (0 <= vel x * (pos y - pos x) * (y - x)) /\ (y <> x -> pos y <> pos x) /\
      Rabs (pos y - pos x) < 1).
    { intros y Hy. pose proof (Rmin_l r1 r2). pose proof (Rmin_r r1 r2).
      destruct (MVT_gen pos x y vel) as (c & Hc & Em).
      - intros w _. apply (velocity_is_derivative _ _ K).
      - intros w _. apply continuity_pt_filterlim, (pos_continuous _ _ K).
      - assert (Nc : Rabs (vel c - vel x) < Rabs (vel x)).
        { apply N2. apply Rabs_def2 in Hy. unfold Rmin, Rmax in Hc.
          apply Rabs_def1; destruct (Rle_dec x y); lra. }
        assert (Sc : 0 < vel x * vel c).
        { revert Nc. unfold Rabs. repeat destruct Rcase_abs; intro; nra. }
        rewrite Em. split; [| split].
        + replace (vel x * (vel c * (y - x)) * (y - x)) with (vel x * vel c * (y - x) ^ 2) by ring.
          apply Rmult_le_pos; [lra | apply pow2_ge_0].
        + intros Ny Ep. assert (vel c * (y - x) = 0) as Z0 by lra.
          apply Rmult_integral in Z0. destruct Z0 as [Z0 | Z0]; [rewrite Z0 in Sc; lra | lra].
        + rewrite <- Em. apply N1. lra. }
    intros u Hu.
    assert (Side : forall y, (y = u \/ Rmin x u < y < Rmax x u) ->
      0 <= vel x * (pos y - pos x) * (y - x) /\ (y <> x -> pos y <> pos x) /\
      Rabs (pos y - pos x) < 1).
    { intros y [-> | Hy]; apply Close; [exact Hu | apply (Between _ u); assumption]. }
    assert (Ahead : 0 <= vel x * (u - x) -> on_tick pos z x u).
    { intro A. assert (Up : forall y, (y = u \/ Rmin x u < y < Rmax x u) -> IZR z <= pos y < IZR z + 1).
      { intros y Hy. destruct (Side y Hy) as (S1 & S2 & S3). apply Rabs_def2 in S3. split; [| lra].
        destruct (Req_dec y x) as [-> | Ny]; [lra |].
        assert (0 < vel x * (y - x) \/ y = u).
        { destruct Hy as [-> | Hy]; [right; reflexivity | left]. unfold Rmin, Rmax in Hy.
          destruct (Rle_dec x u); nra. }
        destruct (Rle_lt_dec (pos x) (pos y)); [lra | exfalso].
        assert (0 < vel x * (y - x)).
        { destruct H as [H | ->]; [exact H |].
          destruct A as [A | A]; [exact A |]. symmetry in A. apply Rmult_integral in A. lra. }
        nra. }
      split; [| split; [lra |]].
      - intros y Hy. apply floor_unique, Up. right. exact Hy.
      - specialize (Up u (or_introl eq_refl)). lra. }
    assert (Behind : vel x * (u - x) < 0 -> on_tick pos (z - 1) x u).
    { intro A. assert (Dn : forall y, (y = u \/ Rmin x u < y < Rmax x u) -> IZR z - 1 <= pos y < IZR z).
      { intros y Hy. destruct (Side y Hy) as (S1 & S2 & S3). apply Rabs_def2 in S3. split; [lra |].
        assert (vel x * (y - x) < 0).
        { destruct Hy as [-> | Hy]; [exact A |]. unfold Rmin, Rmax in Hy.
          destruct (Rle_dec x u); nra. }
        assert (y <> x) as Ny by (intros ->; lra). specialize (S2 Ny).
        destruct (Rlt_le_dec (pos y) (pos x)); [lra | exfalso].
        assert (0 < pos y - pos x) by lra. nra. }
      split; [| rewrite minus_IZR; split; [lra |]].
      - intros y Hy. apply floor_unique. rewrite minus_IZR.
        specialize (Dn y (or_intror Hy)). lra.
      - specialize (Dn u (or_introl eq_refl)). lra. }
    destruct (Rle_lt_dec 0 (vel x * (u - x))) as [A | A];
      [exists z; apply Ahead, A | exists (z - 1)%Z; apply Behind, A].
  - set (m := Rmin (pos x - IZR z) (IZR z + 1 - pos x)).
    destruct (continuous_near pos x m (pos_continuous _ _ K x)) as (r & R1 & N1).
    { apply Rmin_glb_lt; lra. }
    assert (In : forall y, Rabs (y - x) < r -> IZR z <= pos y < IZR z + 1).
    { intros y Hy. specialize (N1 y Hy). apply Rabs_def2 in N1.
      pose proof (Rmin_l (pos x - IZR z) (IZR z + 1 - pos x)).
      pose proof (Rmin_r (pos x - IZR z) (IZR z + 1 - pos x)). fold m in H, H0. lra. }
    exists r. split; [exact R1 |]. intros u Hu. exists z. split; [| split].
    + intros y Hy. apply floor_unique, In, (Between _ u); assumption.
    + lra.
    + specialize (In u Hu). lra.
Qed.

(** Near an instant of rest on a tick edge the force is bounded and H_e nearly constant. *)
Lemma singular : forall x, floor (pos x) = pos x -> vel x = 0 -> forall eps, 0 < eps ->
  exists r, 0 < r /\ forall u, Rabs (u - x) < r ->
    Rabs (work u) <= eps /\
    Rabs (quantized_potential (pos u) - quantized_potential (pos x)) <= eps * Rabs (u - x).
Proof.
  intros x Fx Vx eps He. destruct (floor_integer (pos x)) as [z Hz]. rewrite Fx in Hz.
  set (M := Rabs (IZR z) + 1). assert (MP : 1 <= M) by (unfold M; pose proof (Rabs_pos (IZR z)); lra).
  assert (HM : - M + 1 <= IZR z <= M - 1).
  { pose proof (Rle_abs (IZR z)). pose proof (Rle_abs (- IZR z)) as B. rewrite Rabs_Ropp in B.
    unfold M. lra. }
  destruct (continuous_near pos x 1 (pos_continuous _ _ K x)) as (r1 & R1 & N1); [lra |].
  assert (Ep : 0 < eps / M) by (apply Rdiv_lt_0_compat; lra).
  assert (EM : M * (eps / M) = eps) by (field; lra).
  destruct (continuous_near vel x (eps / M) (velocity_continuous _ _ K x) Ep) as (r2 & R2 & N2).
  exists (Rmin r1 r2). split; [apply Rmin_glb_lt; assumption |].
  intros u Hu. pose proof (Rmin_l r1 r2). pose proof (Rmin_r r1 r2).
  assert (U1 : Rabs (pos u - pos x) < 1) by (apply N1; lra).
  assert (Slow : forall y, Rabs (y - x) <= Rabs (u - x) -> Rabs (vel y) <= eps / M).
  { intros y Hy. specialize (N2 y ltac:(lra)). rewrite Vx, Rminus_0_r in N2. lra. }
  apply Rabs_def2 in U1. split.
  - unfold work. rewrite Rabs_mult, <- EM.
    apply Rmult_le_compat; try apply Rabs_pos; [| apply Slow; lra].
    assert (measured (pos u) = IZR z + 1 / 2 \/ measured (pos u) = IZR z - 1 + 1 / 2) as Hm.
    { unfold measured. destruct (Rle_lt_dec (IZR z) (pos u)).
      - left. rewrite (floor_unique (pos u) z); lra.
      - right. rewrite (floor_unique (pos u) (z - 1)); rewrite minus_IZR; lra. }
    apply Rabs_le. destruct Hm as [-> | ->]; lra.
  - assert (Lip : Rabs (quantized_potential (pos u) - quantized_potential (pos x))
                  <= M * Rabs (pos u - pos x)).
    { rewrite (quantized_potential_linear z (pos x)) by lra.
      destruct (Rle_lt_dec (IZR z) (pos u)).
      - rewrite (quantized_potential_linear z (pos u)) by lra.
        replace (_ - _) with ((IZR z + 1 / 2) * (pos u - pos x)) by field.
        rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos | apply Rabs_le; lra].
      - rewrite (quantized_potential_linear (z - 1) (pos u)) by (rewrite minus_IZR; lra).
        rewrite minus_IZR, Hz.
        replace (_ - _) with ((IZR z - 1 / 2) * (pos u - IZR z)) by field.
        rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos | apply Rabs_le; lra]. }
    destruct (MVT_gen pos x u vel) as (c & Hc & Em).
    + intros w _. apply (velocity_is_derivative _ _ K).
    + intros w _. apply continuity_pt_filterlim, (pos_continuous _ _ K).
    + assert (Rabs (vel c) <= eps / M).
      { apply Slow. unfold Rmin, Rmax in Hc. unfold Rabs.
        destruct (Rle_dec x u); repeat destruct Rcase_abs; lra. }
      rewrite Em, Rabs_mult in Lip. eapply Rle_trans; [exact Lip |].
      rewrite <- EM, Rmult_assoc. apply Rmult_le_compat_l; [lra |].
      apply Rmult_le_compat_r; [apply Rabs_pos | assumption].
Qed.

Lemma regular_or_singular : forall x,
  (floor (pos x) <> pos x \/ vel x <> 0) \/ (floor (pos x) = pos x /\ vel x = 0).
Proof.
  intro x. destruct (Req_dec (floor (pos x)) (pos x)); destruct (Req_dec (vel x) 0); tauto.
Qed.

Lemma work_integrable : forall a b, a <= b -> ex_RInt work a b.
Proof.
  intros a b ab. apply integrable_by_shrinking. intros eps He.
  apply integrable_locally; [| exact ab]. intro x.
  destruct (regular_or_singular x) as [Hr | [F0 V0]].
  - destruct (regular x Hr) as (r & R1 & N). exists r. split; [exact R1 |].
    intros u Hu. destruct (N u Hu) as (z & Hz). exact (shrunk_on_tick eps z x u Hz).
  - destruct (singular x F0 V0 eps He) as (r & R1 & N). exists r. split; [exact R1 |].
    intros u Hu. apply ex_RInt_ext with (fun _ => 0).
    + intros y Hy. symmetry. apply shrink_small, N. apply Rabs_def2 in Hu.
      unfold Rmin, Rmax in Hy. apply Rabs_def1; destruct (Rle_dec x u); lra.
    + apply (@ex_RInt_const R_NormedModule).
Qed.

(** EQ-16/17 (along a motion): the work done against the quantized spring is the change of
    H_e, whatever the motion. *)
Theorem EQ_16_along : forall a b, a <= b ->
  is_RInt work a b (quantized_potential (pos b) - quantized_potential (pos a)).
Proof.
  intros a b ab. pose proof (work_integrable a b ab) as Iab.
  assert (Any : forall s t, ex_RInt work s t).
  { intros s t. destruct (Rle_lt_dec s t); [apply work_integrable; lra |].
    apply (@ex_RInt_swap R_NormedModule), work_integrable. lra. }
  set (G := fun u => quantized_potential (pos u) - RInt work a u).
  assert (DG : forall x, is_derive G x 0).
  { intro x. apply is_derive_Reals. intros eps He.
    assert (Step : exists r, 0 < r /\ forall u, Rabs (u - x) < r ->
              Rabs (G u - G x) <= eps / 2 * Rabs (u - x)).
    { assert (GE : forall u, G u - G x
                = quantized_potential (pos u) - quantized_potential (pos x) - RInt work x u).
      { intro u. unfold G. rewrite (RInt_split work a x u) by apply Any. ring. }
      destruct (regular_or_singular x) as [Hr | [F0 V0]].
      - destruct (regular x Hr) as (r & R1 & N). exists r. split; [exact R1 |].
        intros u Hu. destruct (N u Hu) as (z & Hz). rewrite GE.
        rewrite (is_RInt_unique _ _ _ _ (work_on_tick z x u Hz)).
        replace (_ - _ - _) with 0 by ring. rewrite Rabs_R0.
        apply Rmult_le_pos; [lra | apply Rabs_pos].
      - destruct (singular x F0 V0 (eps / 4)) as (r & R1 & N); [lra |]. exists r. split; [exact R1 |].
        intros u Hu. rewrite GE.
        assert (B : Rabs (RInt work x u) <= Rabs (u - x) * (eps / 4)).
        { assert (Near : forall y, Rmin x u <= y <= Rmax x u -> Rabs (work y) <= eps / 4).
          { intros y Hy. apply N. apply Rabs_def2 in Hu. unfold Rmin, Rmax in Hy.
            apply Rabs_def1; destruct (Rle_dec x u); lra. }
          destruct (Rle_lt_dec x u) as [S | S].
          - rewrite (Rabs_right (u - x)) by lra. apply abs_RInt_le_const; [exact S | apply Any |].
            intros y Hy. apply Near. rewrite Rmin_left, Rmax_right by lra. exact Hy.
          - replace (RInt work x u) with (- RInt work u x)
              by (apply (@opp_RInt_swap R_CompleteNormedModule), Any).
            rewrite Rabs_Ropp, (Rabs_left (u - x)) by lra.
            replace (- (u - x)) with (x - u) by ring.
            apply abs_RInt_le_const; [lra | apply Any |].
            intros y Hy. apply Near. rewrite Rmin_right, Rmax_left by lra. exact Hy. }
        destruct (N u Hu) as [_ H2].
        eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra. }
    destruct Step as (r & R1 & N). exists (mkposreal r R1). intros h Hh Hr. simpl in Hr.
    specialize (N (x + h)). replace (x + h - x) with h in N by ring. specialize (N Hr).
    rewrite Rminus_0_r. unfold Rdiv. rewrite Rabs_mult, Rabs_inv.
    pose proof (Rabs_pos_lt h Hh). apply Rmult_lt_reg_r with (Rabs h); [assumption |].
    rewrite Rmult_assoc, Rinv_l by lra. nra. }
  destruct (MVT_gen G a b (fun _ => 0)) as (c & _ & E).
  - intros x _. apply DG.
  - intros x _. apply continuity_pt_filterlim, (ex_derive_continuous G). exists 0. apply DG.
  - replace (quantized_potential (pos b) - quantized_potential (pos a)) with (RInt work a b);
      [apply RInt_is, Any |].
    unfold G in E. rewrite RInt_point in E. change zero with 0 in E. lra.
Qed.

End Along.
