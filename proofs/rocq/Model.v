(** * Model: a motion of the device that obeys (6), and its energy balance.

    Equation by equation:
    - (1), (2): the physical model in SI units; (3), (4), (7) only change units, so
      everything here is dimensionless.
    - (5): on the h-th sampling interval the wall's force is the constant [held h].
      What it is computed from is left to the theorems: one sample, a delayed one,
      two of them, a D/A step.
    - (6): in its integrated form, so that the forces need only be integrable and
      the acceleration need not exist where they jump.
    - Coulomb friction is a force [friction] with friction * v = sigma |v| and
      |friction| <= sigma: where the device moves it is sigma sgn v, where it rests
      it is anything that can hold it (sticking).
    - The operator's force [hand] is any integrable function of time.
    - The sampling instants [ts 0 < ts 1 < ...] are any increasing sequence; the
      paper's are 0, 1, 2, ...  Late and early samples are covered (TH-JITTER). *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus.
Open Scope R_scope.

(** A position with a continuous velocity.  (The motion of interest is on
    [ts 0, infinity); any such motion extends to the whole line.) *)
Record kinematic (pos vel : R -> R) : Prop := {
  velocity_is_derivative : forall t, is_derive pos t (vel t);
  velocity_continuous : forall t, continuous vel t
}.

(** Sampling instants. *)
Definition increasing (ts : nat -> R) : Prop := forall h, ts h < ts (S h).

(** No interval longer than the sampling period. *)
Definition on_time (ts : nat -> R) : Prop := forall h, ts (S h) - ts h <= 1.

(** The parameters of (7); [mu] is positive, friction does not push. *)
Record physical (mu beta sigma : R) : Prop := {
  mu_positive : 0 < mu;
  beta_nonneg : 0 <= beta;
  sigma_nonneg : 0 <= sigma
}.

(** A motion that obeys (6) with Coulomb friction, under the held forces [held]. *)
Record obeys (mu beta sigma : R) (ts : nat -> R) (held : nat -> R)
             (pos vel friction hand : R -> R) : Prop := {
  is_kinematic : kinematic pos vel;
  friction_opposes : forall t, friction t * vel t = sigma * Rabs (vel t);
  friction_bounded : forall t, Rabs (friction t) <= sigma;
  friction_integrable : forall h, ex_RInt friction (ts h) (ts (S h));
  hand_integrable : forall h, ex_RInt hand (ts h) (ts (S h));
  newton : forall h t, ts h <= t <= ts (S h) ->
    mu * (vel t - vel (ts h))
    = RInt (fun u => hand u + held h - beta * vel u - friction u) (ts h) t
}.

(** Energy that friction takes, (23). *)
Definition dissipated (beta sigma : R) (vel : R -> R) (s t : R) : R :=
  RInt (fun u => friction_power beta sigma (vel u)) s t.

(** Energy that the operator puts in: the left-hand side of (12), (13). *)
Definition operator_energy (vel hand : R -> R) (s t : R) : R :=
  RInt (fun u => hand u * vel u) s t.

(** [r] is the end of interval [h] in a run that stops at [t] in interval [N]. *)
Definition reached (ts : nat -> R) (N : nat) (t : R) (h : nat) (r : R) : Prop :=
  (h < N)%nat /\ r = ts (S h) \/ h = N /\ r = t.

Lemma sample_order : forall ts, increasing ts -> forall i j, (i <= j)%nat -> ts i <= ts j.
Proof.
  intros ts T i j H. induction H as [| j _ IH]; [lra |]. specialize (T j). lra.
Qed.

Lemma reached_range : forall ts, increasing ts -> forall N t, ts N <= t <= ts (S N) ->
  forall h r, reached ts N t h r -> ts 0%nat <= ts h /\ r <= t /\ r <= ts (S h).
Proof.
  intros ts T N t Ht h r [[Hh ->] | [-> ->]].
  - pose proof (sample_order ts T 0 h ltac:(lia)). pose proof (sample_order ts T (S h) N Hh). lra.
  - pose proof (sample_order ts T 0 N ltac:(lia)). lra.
Qed.

Section Kinematics.

Variables pos vel : R -> R.
Hypothesis K : kinematic pos vel.

Lemma pos_continuous : forall t, continuous pos t.
Proof.
  intro t. apply (ex_derive_continuous pos). exists (vel t).
  apply (velocity_is_derivative _ _ K).
Qed.

Lemma vel_integral : forall s t, is_RInt vel s t (pos t - pos s).
Proof.
  intros. apply is_RInt_primitive;
    [apply (velocity_is_derivative _ _ K) | apply (velocity_continuous _ _ K)].
Qed.

Lemma speed_integrable : forall s t, ex_RInt (fun u => Rabs (vel u)) s t.
Proof.
  intros. apply ex_RInt_cont. intro u. apply continuous_Rabs, (velocity_continuous _ _ K).
Qed.

Lemma square_integrable : forall s t, ex_RInt (fun u => vel u ^ 2) s t.
Proof.
  intros. apply ex_RInt_ext with (fun u => vel u * vel u); [over_R; ring |].
  apply ex_RInt_cont. intro u.
  apply continuous_Rmult; apply (velocity_continuous _ _ K).
Qed.

Lemma power_integrable : forall beta sigma s t,
  ex_RInt (fun u => friction_power beta sigma (vel u)) s t.
Proof.
  intros. apply ex_RInt_cont. intro u.
  apply continuous_friction_power, (velocity_continuous _ _ K).
Qed.

(** EQ-23: what friction takes is its viscous part plus its Coulomb part. *)
Theorem EQ_23 : forall beta sigma s t,
  dissipated beta sigma vel s t
  = beta * RInt (fun u => vel u ^ 2) s t + sigma * RInt (fun u => Rabs (vel u)) s t.
Proof.
  intros. unfold dissipated, friction_power. apply is_RInt_unique.
  apply (@is_RInt_plus R_NormedModule (fun u => beta * vel u ^ 2) (fun u => sigma * Rabs (vel u))).
  - apply (@is_RInt_scal R_NormedModule), RInt_is, square_integrable.
  - apply (@is_RInt_scal R_NormedModule), RInt_is, speed_integrable.
Qed.

(** EQ-24: the Coulomb part is at least sigma |d| (triangle inequality). *)
Theorem EQ_24 : forall sigma s t, s <= t -> 0 <= sigma ->
  sigma * Rabs (pos t - pos s) <= sigma * RInt (fun u => Rabs (vel u)) s t.
Proof.
  intros sigma s t H Hs. apply Rmult_le_compat_l; [exact Hs |].
  rewrite <- (is_RInt_unique _ _ _ _ (vel_integral s t)).
  apply abs_RInt_le; [exact H |]. exists (pos t - pos s). apply vel_integral.
Qed.

(** Cauchy-Schwarz for the velocity against the constant 1. *)
Lemma cauchy_schwarz : forall s t, s < t ->
  (pos t - pos s) ^ 2 / (t - s) <= RInt (fun u => vel u ^ 2) s t.
Proof.
  intros s t H. set (d := pos t - pos s). set (m := d / (t - s)).
  assert (Q : is_RInt (fun u => vel u ^ 2 + (- 2 * m * vel u + m ^ 2)) s t
                (RInt (fun u => vel u ^ 2) s t + (- 2 * m * d + (t - s) * m ^ 2))).
  { apply (@is_RInt_plus R_NormedModule (fun u => vel u ^ 2)).
    - apply RInt_is, square_integrable.
    - apply (@is_RInt_plus R_NormedModule (fun u => - 2 * m * vel u) (fun _ => m ^ 2)).
      + apply (@is_RInt_scal R_NormedModule), vel_integral.
      + apply (@is_RInt_const R_NormedModule). }
  apply is_RInt_ge_0 in Q; [| lra | intros; pose proof (pow2_ge_0 (vel x - m)); nra].
  assert (M : m * (t - s) = d) by (unfold m; field; lra).
  replace (d ^ 2 / (t - s)) with (m * d) by (unfold m; field; lra). nra.
Qed.

(** EQ-25: the viscous part is at least beta d^2 / dtau. *)
Theorem EQ_25 : forall beta s t, s < t -> 0 <= beta ->
  beta * (pos t - pos s) ^ 2 / (t - s) <= beta * RInt (fun u => vel u ^ 2) s t.
Proof.
  intros beta s t H Hb. unfold Rdiv. rewrite Rmult_assoc.
  apply Rmult_le_compat_l; [exact Hb | apply cauchy_schwarz, H].
Qed.

(** EQ-26: the sum of (24) and (25) bounds the dissipated energy from below. *)
Theorem EQ_26 : forall beta sigma s t, s < t -> 0 <= beta -> 0 <= sigma ->
  dissipated_lower beta sigma (pos t - pos s) (t - s) <= dissipated beta sigma vel s t.
Proof.
  intros beta sigma s t H Hb Hs. rewrite EQ_23. unfold dissipated_lower.
  pose proof (EQ_24 sigma s t (Rlt_le _ _ H) Hs). pose proof (EQ_25 beta s t H Hb). lra.
Qed.

(** EQ-28: the mean speed of a step is the speed at some instant of it, and over at
    most one period the displacement is at most that speed. *)
Theorem EQ_28 : forall s t, s < t ->
  exists u, s <= u <= t /\ Rabs (pos t - pos s) = Rabs (vel u) * (t - s)
            /\ mean_speed (pos t - pos s) (t - s) = Rabs (vel u)
            /\ (t - s <= 1 -> Rabs (pos t - pos s) <= Rabs (vel u)).
Proof.
  intros s t H. destruct (MVT_gen pos s t vel) as (u & Hu & E).
  - intros x _. apply (velocity_is_derivative _ _ K).
  - intros x _. apply continuity_pt_filterlim, pos_continuous.
  - rewrite Rmin_left, Rmax_right in Hu by lra. exists u. rewrite E.
    assert (A : Rabs (vel u * (t - s)) = Rabs (vel u) * (t - s)).
    { rewrite Rabs_mult, (Rabs_right (t - s)) by lra. reflexivity. }
    unfold mean_speed. rewrite A. repeat split; try lra.
    + field. lra.
    + intro. pose proof (Rabs_pos (vel u)). nra.
Qed.

End Kinematics.

Section Energy.

Variables mu beta sigma : R.
Variables ts held : nat -> R.
Variables pos vel friction hand : R -> R.
Hypothesis P : physical mu beta sigma.
Hypothesis O : obeys mu beta sigma ts held pos vel friction hand.

Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.

Definition net_force (h : nat) (u : R) : R := hand u + held h - beta * vel u - friction u.

Lemma net_force_integrable : forall h s t, ts h <= s <= t -> t <= ts (S h) ->
  ex_RInt (net_force h) s t.
Proof.
  intros h s t H1 H2. apply ex_RInt_part with (ts h) (ts (S h)); [| lra | lra].
  unfold net_force. apply (@ex_RInt_minus R_NormedModule); [| apply (friction_integrable _ _ _ _ _ _ _ _ _ O)].
  apply (@ex_RInt_minus R_NormedModule).
  - apply (@ex_RInt_plus R_NormedModule); [apply (hand_integrable _ _ _ _ _ _ _ _ _ O) |].
    apply (@ex_RInt_const R_NormedModule).
  - apply (@ex_RInt_scal R_NormedModule). eexists. apply (vel_integral _ _ K).
Qed.

(** EQ-6 (energy): over any part of a sampling interval from its sample, the operator
    puts in what the kinetic energy grows by, less the held force's work, plus what
    friction takes. *)
Theorem EQ_6_energy : forall h t, ts h <= t <= ts (S h) ->
  is_RInt (fun u => hand u * vel u) (ts h) t
    (kinetic mu (vel t) - kinetic mu (vel (ts h)) - held h * (pos t - pos (ts h))
     + dissipated beta sigma vel (ts h) t).
Proof.
  intros h t Ht. pose proof (mu_positive _ _ _ P) as M0. set (a := ts h) in *.
  destruct (Req_dec a t) as [E | E].
  { rewrite <- E. unfold dissipated. rewrite RInt_point.
    replace (_ - _ - _ + _) with 0 by (unfold zero; simpl; ring).
    apply (@is_RInt_point R_NormedModule). }
  assert (I : ex_RInt (fun u => net_force h u / mu) a t).
  { apply ex_RInt_ext with (fun u => / mu * net_force h u); [intros; apply Rmult_comm |].
    apply (@ex_RInt_scal R_NormedModule), net_force_integrable; unfold a in *; lra. }
  destruct (ex_RInt_ub _ _ _ I) as (B & HB).
  assert (G : forall s r, a <= s <= r -> r <= t ->
            vel r - vel s = RInt (fun u => net_force h u / mu) s r).
  { intros s r H1 H2.
    rewrite (RInt_ext _ (fun u => / mu * net_force h u)) by (intros; apply Rmult_comm).
    rewrite (@RInt_scal R_CompleteNormedModule) by (apply net_force_integrable; unfold a in *; lra).
    pose proof (newton _ _ _ _ _ _ _ _ _ O h s) as N1. pose proof (newton _ _ _ _ _ _ _ _ _ O h r) as N2.
    fold a in N1, N2. specialize (N1 ltac:(lra)). specialize (N2 ltac:(lra)).
    fold (net_force h) in N1, N2.
    pose proof (RInt_split (net_force h) a s r) as Sp.
    rewrite Sp in N2 by (apply net_force_integrable; unfold a in *; lra).
    change (vel r - vel s = / mu * RInt (net_force h) s r).
    apply Rmult_eq_reg_l with mu; [| lra]. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. lra. }
  assert (W : is_RInt (fun u => net_force h u / mu * vel u) a t ((vel t ^ 2 - vel a ^ 2) / 2)).
  { apply work_of_growth with B; [lra | exact I | | exact G].
    intros u Hu. apply HB. rewrite Rmin_left, Rmax_right by lra. exact Hu. }
  set (kin := (vel t ^ 2 - vel a ^ 2) / 2) in *.
  replace (_ - _ - _ + _) with (mu * kin + (- held h * (pos t - pos a) + dissipated beta sigma vel a t))
    by (unfold kinetic, kin; field).
  apply is_RInt_ext with (fun u => mu * (net_force h u / mu * vel u)
                          + (- held h * vel u + friction_power beta sigma (vel u))).
  - over_R. unfold net_force, friction_power.
    rewrite <- (friction_opposes _ _ _ _ _ _ _  _ _ O x). field. lra.
  - apply (@is_RInt_plus R_NormedModule (fun u => mu * (net_force h u / mu * vel u))).
    + apply (@is_RInt_scal R_NormedModule), W.
    + apply (@is_RInt_plus R_NormedModule (fun u => - held h * vel u)).
      * apply (@is_RInt_scal R_NormedModule), (vel_integral _ _ K).
      * apply RInt_is, (power_integrable _ _ K).
Qed.

(** EQ-13 (one interval): with any potential [V] as the counterpart, the operator's energy
    is the growth of the storage, plus what friction takes, less what is generated. *)
Theorem EQ_13_interval : forall (V : R -> R) h t, ts h <= t <= ts (S h) ->
  is_RInt (fun u => hand u * vel u) (ts h) t
    (kinetic mu (vel t) + V (pos t) - (kinetic mu (vel (ts h)) + V (pos (ts h)))
     + (dissipated beta sigma vel (ts h) t
        - generated (held h) (pos (ts h)) (pos t) (V (pos (ts h))) (V (pos t)))).
Proof.
  intros V h t Ht. pose proof (EQ_6_energy h t Ht) as E.
  replace (_ - (_ + V (pos (ts h))) + _) with
    (kinetic mu (vel t) - kinetic mu (vel (ts h)) - held h * (pos t - pos (ts h))
     + dissipated beta sigma vel (ts h) t) by (unfold generated; ring).
  exact E.
Qed.

(** EQ-12/13/14 (a run): if every interval reached pays, friction taking at least what is
    generated and what an extra storage [W] grows by, then the operator has put in at
    least the growth of the storage.  [X h t] is [W] on the way from sample h to h + 1. *)
Theorem EQ_14_run : forall (V : R -> R) (W : nat -> R) (X : nat -> R -> R),
  increasing ts ->
  (forall h, X h (ts (S h)) = W (S h)) ->
  forall N t, ts N <= t <= ts (S N) ->
  (forall h r, reached ts N t h r ->
     generated (held h) (pos (ts h)) (pos r) (V (pos (ts h))) (V (pos r)) + X h r - W h
     <= dissipated beta sigma vel (ts h) r) ->
  ex_RInt (fun u => hand u * vel u) (ts 0%nat) t /\
  kinetic mu (vel t) + V (pos t) + X N t
  <= kinetic mu (vel (ts 0%nat)) + V (pos (ts 0%nat)) + W 0%nat
     + operator_energy vel hand (ts 0%nat) t.
Proof.
  intros V W X Hinc HX N t Ht Hpay.
  assert (A : forall n, (n <= N)%nat -> exists E,
    is_RInt (fun u => hand u * vel u) (ts 0%nat) (ts n) E /\
    kinetic mu (vel (ts n)) + V (pos (ts n)) + W n
    <= kinetic mu (vel (ts 0%nat)) + V (pos (ts 0%nat)) + W 0%nat + E).
  { induction n as [| n IH]; intro Hn.
    - exists 0. split; [apply (@is_RInt_point R_NormedModule) | lra].
    - destruct IH as (E & I & L); [lia |].
      pose proof (Hinc n) as Hi.
      eexists. split.
      + apply is_RInt_join with (1 := I). apply (EQ_13_interval V n (ts (S n))). lra.
      + specialize (Hpay n (ts (S n)) (or_introl (conj Hn eq_refl))). rewrite HX in Hpay. lra. }
  destruct (A N (le_n N)) as (E & I & L).
  specialize (Hpay N t (or_intror (conj eq_refl eq_refl))).
  pose proof (is_RInt_join _ _ _ _ _ _ I (EQ_13_interval V N t Ht)) as J.
  split; [eexists; exact J |].
  unfold operator_energy. rewrite (is_RInt_unique _ _ _ _ J). lra.
Qed.

End Energy.
