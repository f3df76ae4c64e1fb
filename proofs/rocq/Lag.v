(** * Lag: TH-LAG, an amplifier whose force follows its command with a first-order lag.

    On [h, h + 1) the force goes from what it is towards the command u_h, with time constant theta
    (in periods).  With the exact positions as commands it would be -(x_h - y_h w), w = exp
    (-(t - h)/theta), y_h what it is behind at the sample; the storage is x^2/2 + p y^2. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller ActuatorCost InstantRun LagForm.
Open Scope R_scope.

(** What is left at [t] of what was behind at sample [h]. *)
Definition lag_left (theta : R) (h : nat) (t : R) : R := exp (- (t - INR h) / theta).

(** The force of a first-order lag with the commands [u]. *)
Definition lagging (theta : R) (u : nat -> R) (force : R -> R) : Prop :=
  forall h t, INR h <= t <= INR (S h) ->
  force t = u h + (force (INR h) - u h) * lag_left theta h t.

(** It is the solution of theta force' = u - force that starts where the force is. *)
Theorem TH_LAG_equation : forall theta u f0 h t, 0 < theta ->
  is_derive (fun t => u + (f0 - u) * lag_left theta h t) t
            ((u - (u + (f0 - u) * lag_left theta h t)) / theta).
Proof.
  intros theta u f0 h t H. unfold lag_left. auto_derive; [exact I |].
  change (- (t + - INR h) * / theta) with (- (t - INR h) / theta).
  generalize (exp (- (t - INR h) / theta)). intro x. over_R. field. lra.
Qed.

(** How far the force is behind the samples' positions. *)
Fixpoint lag_behind (theta : R) (pos : R -> R) (y0 : R) (h : nat) : R :=
  match h with
  | O => y0
  | S g => (pos (INR (S g)) - pos (INR g)) + lag_decay theta * lag_behind theta pos y0 g
  end.

Lemma lag_left_continuous : forall theta h t, 0 < theta -> continuous (lag_left theta h) t.
Proof.
  intros theta h t H. apply (ex_derive_continuous (lag_left theta h)).
  unfold lag_left. auto_derive. exact I.
Qed.

Lemma lag_left_start : forall theta h, lag_left theta h (INR h) = 1.
Proof.
  intros. unfold lag_left. replace (- (INR h - INR h) / theta) with 0 by (unfold Rdiv; ring).
  apply exp_0.
Qed.

Lemma lag_left_end : forall theta h, lag_left theta h (INR (S h)) = lag_decay theta.
Proof.
  intros. unfold lag_left, lag_decay. rewrite S_INR. do 2 f_equal. ring.
Qed.

Lemma lag_left_between : forall theta h t, 0 < theta -> INR h <= t -> 0 < lag_left theta h t <= 1.
Proof.
  intros theta h t H Ht. unfold lag_left. split; [apply exp_pos |].
  rewrite <- exp_0. assert (0 <= (t - INR h) / theta) by (apply Rdiv_le_0_compat; lra).
  destruct (Req_dec ((t - INR h) / theta) 0) as [Z | Z].
  - replace (- (t - INR h) / theta) with (- ((t - INR h) / theta)) by (unfold Rdiv; ring).
    rewrite Z, Ropp_0. lra.
  - apply Rlt_le, exp_increasing.
    replace (- (t - INR h) / theta) with (- ((t - INR h) / theta)) by (unfold Rdiv; ring). lra.
Qed.

(** The Gram matrix, as the integral over a whole period. *)
Lemma gram_integral : forall theta h a b, 0 < theta ->
  is_RInt (fun u => (a + b * lag_left theta h u) ^ 2) (INR h) (INR (S h))
          (a ^ 2 + 2 * a * b * lag_alpha theta + b ^ 2 * lag_gamma theta).
Proof.
  intros theta h a b H.
  set (F := fun u => a ^ 2 * u - 2 * a * b * theta * lag_left theta h u
                     - b ^ 2 * theta * lag_left theta h u ^ 2 / 2).
  replace (a ^ 2 + 2 * a * b * lag_alpha theta + b ^ 2 * lag_gamma theta)
    with (F (INR (S h)) - F (INR h)).
  - apply is_RInt_primitive.
    + intro t. unfold F, lag_left. auto_derive; [exact I |].
      change (- (t + - INR h) * / theta) with (- (t - INR h) / theta).
      generalize (exp (- (t - INR h) / theta)). intro x. over_R. field. lra.
    + intro t. apply (ex_derive_continuous (fun u => (a + b * lag_left theta h u) ^ 2)).
      unfold lag_left. auto_derive. exact I.
  - unfold F. rewrite lag_left_end, lag_left_start, S_INR.
    unfold lag_alpha, lag_gamma. field.
Qed.

Section Lag.

Variables mu beta sigma : R.
Variables pos vel friction hand force : R -> R.
Variables (theta kappa y0 : R) (force_step : option R) (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis theta_positive : 0 < theta.
Hypothesis step_ok : step_positive force_step.
(** With an encoder [measured] and 1/2; without one the identity and 0. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
(** [kappa] is enough (TH_LAG_kappa_squares). *)
Hypothesis enough_mean : 0 <= spare_mean kappa theta.
Hypothesis enough_square : 0 <= spare_square kappa theta (lag_variance theta).

Definition lag_command (h : nat) : R := stepped force_step (- measure (pos (INR h))).

(** The force that acts on the device is the amplifier's. *)
Hypothesis O : obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t).
Hypothesis amplifier : lagging theta lag_command force.

Let coulomb := e + step_size force_step / 2.
(** At the start it is [y0] behind, but for what quantization explains. *)
Hypothesis start : Rabs (force 0 + (pos 0 - y0)) <= coulomb.

Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.
Let p := lag_memory kappa theta.
Let y := lag_behind theta pos y0.
Let w := lag_left theta.

Lemma command_error_lag : forall h, Rabs (lag_command h + pos (INR h)) <= coulomb.
Proof.
  intro h. pose proof (stepped_error force_step (- measure (pos (INR h))) step_ok) as A.
  pose proof (measure_error (pos (INR h))) as B. unfold lag_command.
  replace (stepped force_step (- measure (pos (INR h))) + pos (INR h))
    with ((stepped force_step (- measure (pos (INR h))) - - measure (pos (INR h)))
          + - (measure (pos (INR h)) - pos (INR h))) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. unfold coulomb. lra.
Qed.

(** A mean of two errors. *)
Lemma mean_error : forall a b s, 0 <= s <= 1 -> Rabs a <= coulomb -> Rabs b <= coulomb ->
  Rabs ((1 - s) * a + s * b) <= coulomb.
Proof.
  intros a b s Hs Ha Hb. eapply Rle_trans; [apply Rabs_triang |].
  rewrite !Rabs_mult, (Rabs_right (1 - s)), (Rabs_right s) by lra. nra.
Qed.

Lemma sample_error : forall h, Rabs (force (INR h) + (pos (INR h) - y h)) <= coulomb.
Proof.
  induction h as [| h IH]; [exact start |].
  rewrite (amplifier h (INR (S h))) by (rewrite S_INR; lra). rewrite lag_left_end.
  pose proof (decay_between theta theta_positive) as E.
  replace (y (S h)) with ((pos (INR (S h)) - pos (INR h)) + lag_decay theta * y h) by reflexivity.
  replace (lag_command h + (force (INR h) - lag_command h) * lag_decay theta
    + (pos (INR (S h)) - (pos (INR (S h)) - pos (INR h) + lag_decay theta * y h)))
    with ((1 - lag_decay theta) * (lag_command h + pos (INR h))
          + lag_decay theta * (force (INR h) + (pos (INR h) - y h))) by ring.
  apply mean_error; [lra | apply command_error_lag | exact IH].
Qed.

(** The force is never farther than quantization from the lag of the exact positions. *)
Lemma force_error : forall h t, INR h <= t <= INR (S h) ->
  Rabs (force t + (pos (INR h) - y h * w h t)) <= coulomb.
Proof.
  intros h t Ht. rewrite (amplifier h t Ht). fold (w h t).
  pose proof (lag_left_between theta h t theta_positive (proj1 Ht)) as B. fold (w h t) in B.
  replace (lag_command h + (force (INR h) - lag_command h) * w h t + (pos (INR h) - y h * w h t))
    with ((1 - w h t) * (lag_command h + pos (INR h))
          + w h t * (force (INR h) + (pos (INR h) - y h))) by ring.
  apply mean_error; [lra | apply command_error_lag | apply sample_error].
Qed.

Lemma left_velocity_continuous : forall h t, continuous (fun u => w h u * vel u) t.
Proof.
  intros h t. apply continuous_Rmult;
    [apply lag_left_continuous, theta_positive | apply (velocity_continuous _ _ K)].
Qed.

(** Z of an interval. *)
Let Z (h : nat) (t : R) : R := RInt (fun u => w h u * vel u) (INR h) t.

(** Of all velocities with these D and Z the integral of the square is at least [lag_gram]. *)
Lemma gram_at_most : forall h t, INR h <= t <= INR (S h) ->
  lag_gram theta (pos t - pos (INR h)) (Z h t) <= square_integral vel (INR h) t.
Proof.
  intros h t Ht. set (D := pos t - pos (INR h)). set (z := Z h t).
  pose proof (det_positive theta theta_positive) as Dt.
  set (a := (lag_gamma theta * D - lag_alpha theta * z) / lag_det theta).
  set (b := (z - lag_alpha theta * D) / lag_det theta).
  assert (C2 : forall u, continuous (fun u => (a + b * w h u) ^ 2) u).
  { intro u. apply (ex_derive_continuous (fun u => (a + b * w h u) ^ 2)).
    unfold w, lag_left. auto_derive. exact I. }
  assert (Part : RInt (fun u => (a + b * w h u) ^ 2) (INR h) t
                 <= a ^ 2 + 2 * a * b * lag_alpha theta + b ^ 2 * lag_gamma theta).
  { rewrite <- (is_RInt_unique _ _ _ _ (gram_integral theta h a b theta_positive)). fold w.
    rewrite (RInt_split _ (INR h) t (INR (S h))) by (apply ex_RInt_cont, C2).
    assert (0 <= RInt (fun u => (a + b * w h u) ^ 2) t (INR (S h))).
    { apply RInt_ge_0; [lra | apply ex_RInt_cont, C2 | intros; apply pow2_ge_0]. }
    lra. }
  assert (Sq : is_RInt (fun u => vel u ^ 2 + ((- 2 * a * vel u + - 2 * b * (w h u * vel u))
                                              + (a + b * w h u) ^ 2)) (INR h) t
    (square_integral vel (INR h) t + ((- 2 * a * D + - 2 * b * z)
                                      + RInt (fun u => (a + b * w h u) ^ 2) (INR h) t))).
  { apply (@is_RInt_plus R_NormedModule (fun u => vel u ^ 2)).
    - apply RInt_is, (square_integrable pos vel K).
    - apply (@is_RInt_plus R_NormedModule (fun u => - 2 * a * vel u + - 2 * b * (w h u * vel u))).
      + apply (@is_RInt_plus R_NormedModule (fun u => - 2 * a * vel u)).
        * apply (@is_RInt_scal R_NormedModule), (vel_integral pos vel K).
        * apply (@is_RInt_scal R_NormedModule). apply RInt_is, ex_RInt_cont, left_velocity_continuous.
      + apply RInt_is, ex_RInt_cont, C2. }
  apply is_RInt_ge_0 in Sq; [| lra |].
  2: { intros u _. pose proof (pow2_ge_0 (vel u - (a + b * w h u))). nra. }
  assert (G1 : a ^ 2 + 2 * a * b * lag_alpha theta + b ^ 2 * lag_gamma theta
               = lag_gram theta D z).
  { unfold lag_gram, a, b. unfold lag_det in *. field. lra. }
  assert (G2 : a * D + b * z = lag_gram theta D z).
  { unfold lag_gram, a, b. field. lra. }
  nra.
Qed.

(** ** The force's work *)

Lemma force_work_integrable : forall h s t, INR h <= s <= t -> t <= INR (S h) ->
  ex_RInt (fun u => force u * vel u) s t.
Proof.
  intros h s t H1 H2.
  apply ex_RInt_ext with
    (fun u => (lag_command h + (force (INR h) - lag_command h) * w h u) * vel u).
  - intros u Hu. rewrite Rmin_left, Rmax_right in Hu by lra.
    rewrite (amplifier h u) by lra. reflexivity.
  - apply ex_RInt_cont. intro u. apply continuous_Rmult; [| apply (velocity_continuous _ _ K)].
    apply (ex_derive_continuous (fun u => lag_command h + (force (INR h) - lag_command h) * w h u)).
    unfold w, lag_left. auto_derive. exact I.
Qed.

Lemma work_integrable : forall h t, INR h <= t <= INR (S h) ->
  ex_RInt (fun u => force u * vel u) 0 t.
Proof.
  induction h as [| h IH]; intros t Ht.
  - apply (force_work_integrable 0); simpl (INR 0) in *; lra.
  - apply (@ex_RInt_Chasles R_NormedModule) with (INR (S h)).
    + apply IH. rewrite S_INR. lra.
    + apply (force_work_integrable (S h)); lra.
Qed.

(** The work of the force up to [t]. *)
Let work (t : R) : R := RInt (fun u => force u * vel u) 0 t.

Lemma work_grows : forall h t, INR h <= t <= INR (S h) ->
  work t - work (INR h) + ((pos t ^ 2 - pos (INR h) ^ 2) / 2)
  <= (pos t - pos (INR h)) ^ 2 / 2 + y h * Z h t + coulomb * RInt (fun u => Rabs (vel u)) (INR h) t.
Proof.
  intros h t Ht. set (x := pos (INR h)). set (D := pos t - x).
  assert (S1 : work t - work (INR h) = RInt (fun u => force u * vel u) (INR h) t).
  { unfold work. rewrite (RInt_split _ 0 (INR h) t); [ring | |].
    - apply (work_integrable h). lra.
    - apply (force_work_integrable h); lra. }
  assert (B : RInt (fun u => force u * vel u) (INR h) t
              <= RInt (fun u => coulomb * Rabs (vel u)
                                + (- x * vel u + y h * (w h u * vel u))) (INR h) t).
  { apply RInt_le; [lra | apply (force_work_integrable h); lra | |].
    - apply ex_RInt_cont. intro u. apply continuous_Rplus.
      + apply continuous_Rmult; [apply continuous_const |].
        apply continuous_Rabs, (velocity_continuous _ _ K).
      + apply continuous_Rplus; apply continuous_Rmult; try apply continuous_const.
        * apply (velocity_continuous _ _ K).
        * apply left_velocity_continuous.
    - intros u Hu. pose proof (force_error h u ltac:(lra)) as E. fold x in E.
      assert (Q : (force u + (x - y h * w h u)) * vel u <= coulomb * Rabs (vel u)).
      { eapply Rle_trans; [apply Rle_abs |]. rewrite Rabs_mult.
        apply Rmult_le_compat_r; [apply Rabs_pos | exact E]. }
      lra. }
  assert (V : RInt (fun u => coulomb * Rabs (vel u) + (- x * vel u + y h * (w h u * vel u))) (INR h) t
              = coulomb * RInt (fun u => Rabs (vel u)) (INR h) t + (- x * D + y h * Z h t)).
  { apply is_RInt_unique.
    apply (@is_RInt_plus R_NormedModule (fun u => coulomb * Rabs (vel u))).
    - apply (@is_RInt_scal R_NormedModule), RInt_is, (speed_integrable pos vel K).
    - apply (@is_RInt_plus R_NormedModule (fun u => - x * vel u)).
      + apply (@is_RInt_scal R_NormedModule), (vel_integral pos vel K).
      + apply (@is_RInt_scal R_NormedModule), RInt_is, ex_RInt_cont, left_velocity_continuous. }
  rewrite S1. replace (pos t) with (x + D) by (unfold D; ring). lra.
Qed.

(** ** The run *)

Let W (h : nat) : R := p * y h ^ 2 + work (INR h).
Let X (h : nat) (t : R) : R :=
  p * ((pos t - pos (INR h)) + lag_decay theta * y h) ^ 2 + work t.

Lemma lag_charge : forall h t, INR h <= t <= INR (S h) ->
  (forall u, INR h <= u <= t -> vel u <> 0 ->
     0 <= margin_8 (beta - kappa) (sigma - coulomb) (vel u)) ->
  generated 0 (pos (INR h)) (pos t) (linear_potential (pos (INR h))) (linear_potential (pos t))
  + X h t - W h <= dissipated beta sigma vel (INR h) t.
Proof.
  intros h t Ht H8.
  pose proof (instant_friction beta sigma kappa coulomb pos vel K (INR h) t (proj1 Ht) H8) as F.
  pose proof (work_grows h t Ht) as G. pose proof (gram_at_most h t Ht) as Gr.
  pose proof (TH_LAG_form kappa theta theta_positive enough_mean enough_square (y h)
    (pos t - pos (INR h)) (Z h t)) as Q. fold p in Q.
  pose proof (lag_kappa_positive kappa theta enough_mean) as K0.
  apply (Rmult_le_compat_l kappa) in Gr; [| lra].
  unfold generated, linear_potential, X, W. lra.
Qed.

(** TH-LAG: if (beta - kappa)|v| + (sigma - e - delta/2) >= 0 at every instant, the operator has put
    in at least the growth of the storage, over any number of intervals, ending anywhere. *)
Theorem TH_LAG : forall t, 0 <= t ->
  criterion_holds (beta - kappa) (sigma - coulomb) vel t ->
  ex_RInt (fun u => hand u * vel u) 0 t /\
  storage mu (pos t) (vel t) - (storage mu (pos 0) (vel 0) + lag_memory kappa theta * y0 ^ 2)
  <= operator_energy vel hand 0 t.
Proof.
  intros t Ht H8. destruct (INR_covers t Ht) as (N & HN).
  destruct (EQ_14_run mu beta sigma INR (fun _ => 0) pos vel friction (fun u => hand u + force u)
    P O linear_potential W X INR_increasing) with (N := N) (t := t) as (I & E).
  - intro h. unfold X, W. reflexivity.
  - exact HN.
  - intros h u Hr.
    destruct (reached_range _ INR_increasing N t HN h u Hr) as (R0 & R1 & R2).
    assert (R3 : INR h <= u).
    { destruct Hr as [[_ ->] | [-> ->]]; [rewrite S_INR; lra | lra]. }
    apply lag_charge; [lra |]. intros v Hv. apply H8. simpl (INR 0) in R0. lra.
  - simpl (INR 0) in *.
    assert (Iw : ex_RInt (fun u => force u * vel u) 0 t) by (apply (work_integrable N); exact HN).
    assert (Ih : is_RInt (fun u => hand u * vel u) 0 t
      (operator_energy vel (fun u => hand u + force u) 0 t - work t))
      by exact (hand_apart vel hand force 0 t Iw I).
    split; [eexists; exact Ih |].
    unfold operator_energy at 1. rewrite (is_RInt_unique _ _ _ _ Ih).
    assert (W0 : work 0 = 0) by (unfold work; rewrite RInt_point; reflexivity).
    pose proof (lag_memory_positive kappa theta theta_positive enough_mean enough_square) as P0.
    fold p in P0. unfold storage. unfold X, W in E. simpl (INR 0) in E.
    change (y 0%nat) with y0 in E. rewrite W0 in E. fold p.
    pose proof (pow2_ge_0 (pos t - pos (INR N) + lag_decay theta * y N)) as Q0.
    assert (0 <= p * (pos t - pos (INR N) + lag_decay theta * y N) ^ 2)
      by (apply Rmult_le_pos; [lra | exact Q0]).
    lra.
Qed.

(** TH-LAG (every operator): with beta >= kappa and sigma >= e + delta/2 the operator never draws
    more than the storage at the start. *)
Theorem TH_LAG_all_speeds : kappa <= beta -> coulomb <= sigma -> forall t, 0 <= t ->
  - operator_energy vel hand 0 t
  <= storage mu (pos 0) (vel 0) + lag_memory kappa theta * y0 ^ 2.
Proof.
  intros Hb Hc t Ht.
  assert (C : criterion_holds (beta - kappa) (sigma - coulomb) vel t)
    by (apply enough_at_all_speeds; lra).
  destruct (TH_LAG t Ht C) as [_ E].
  pose proof (storage_nonneg mu (pos t) (vel t) (mu_positive _ _ _ P)). lra.
Qed.

End Lag.
