(** * LateActuator: TH-LAG for any actuator that only delays, under the laws of the product.

    [late x] is the share of a step of the command that has not reached the device x periods
    after its sample: from 1 down to 0, never up.  [behind t] is what is late at phase t, of all
    samples; m is its mean over the phases and Var its variance. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller ActuatorCost InstantRun Weighted Angles PositiveActuator.
Open Scope R_scope.

(** The force at [t] in interval [h]: the steps of the command, each as far as it has come.  The
    device had rested before sample 0, and so had the actuator. *)
Definition superposed (late : R -> R) (u : nat -> R) (h : nat) (t : R) : R :=
  u h - sum_to h (fun j => late (INR (pred j) + (t - INR h)) * (u (h - pred j)%nat - u (h - j)%nat)).

Definition actuates (late : R -> R) (u : nat -> R) (force : R -> R) : Prop :=
  forall h t, INR h < t < INR (S h) -> force t = superposed late u h t.

Record only_delays (late : R -> R) : Prop := {
  late_is_continuous : forall x, continuous late x;
  late_falls : forall x y, x <= y -> late y <= late x;
  late_share : forall x, 0 <= late x <= 1
}.

(** [behind] is at least what is late of any number of samples. *)
Record behind_covers (late behind : R -> R) : Prop := {
  behind_continuous : forall t, continuous behind t;
  behind_nonneg : forall t, 0 <= behind t;
  behind_all : forall N t, 0 <= t <= 1 ->
    sum_to N (fun j => late (INR (pred j) + t)) <= behind t
}.

Definition mean_of (behind : R -> R) : R := RInt behind 0 1.
Definition variance_of (behind : R -> R) : R :=
  RInt (fun t => behind t ^ 2) 0 1 - mean_of behind ^ 2.

(** A mean with falling weights [s]: bounds carry over. *)
Lemma falling_mean : forall (s b B : nat -> R) N,
  (forall n, s (S n) <= s n) -> (forall n, 0 <= s n <= 1) ->
  (forall n, (n <= N)%nat -> Rabs (b n) <= B n) ->
  Rabs (b 0%nat - sum_to N (fun j => s (pred j) * (b (pred j) - b j)))
  <= B 0%nat - sum_to N (fun j => s (pred j) * (B (pred j) - B j)).
Proof.
  intros s b B N Fall Share Bd.
  assert (G : forall n, (n <= N)%nat ->
    Rabs (b 0%nat - sum_to n (fun j => s (pred j) * (b (pred j) - b j)) - s n * b n)
    <= B 0%nat - sum_to n (fun j => s (pred j) * (B (pred j) - B j)) - s n * B n).
  { induction n as [| n IH]; intro Hn.
    - simpl. pose proof (Share 0%nat). pose proof (Bd 0%nat ltac:(lia)).
      replace (b 0%nat - 0 - s 0%nat * b 0%nat) with ((1 - s 0%nat) * b 0%nat) by ring.
      rewrite Rabs_mult, (Rabs_right (1 - s 0%nat)) by lra. nra.
    - specialize (IH ltac:(lia)). rewrite !sum_to_S. simpl pred.
      pose proof (Fall n). pose proof (Bd (S n) Hn).
      set (x := sum_to n (fun j => s (pred j) * (b (pred j) - b j))) in *.
      set (y := sum_to n (fun j => s (pred j) * (B (pred j) - B j))) in *.
      replace (b 0%nat - (x + s n * (b n - b (S n))) - s (S n) * b (S n))
        with ((b 0%nat - x - s n * b n) + (s n - s (S n)) * b (S n)) by ring.
      eapply Rle_trans; [apply Rabs_triang |].
      rewrite Rabs_mult, (Rabs_right (s n - s (S n))) by lra. nra. }
  specialize (G N (le_n N)). pose proof (Share N). pose proof (Bd N (le_n N)).
  set (x := sum_to N (fun j => s (pred j) * (b (pred j) - b j))) in *.
  set (y := sum_to N (fun j => s (pred j) * (B (pred j) - B j))) in *.
  replace (b 0%nat - x) with ((b 0%nat - x - s N * b N) + s N * b N) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_mult, (Rabs_right (s N)) by lra. nra.
Qed.

Section Moments.

Variables late behind : R -> R.
Hypothesis covers : behind_covers late behind.

Let m : R := mean_of behind.
Let Var : R := variance_of behind.
Let second : R := RInt (fun t => behind t ^ 2) 0 1.

Lemma behind_integrable : ex_RInt behind 0 1.
Proof. apply ex_RInt_cont, (behind_continuous _ _ covers). Qed.

Lemma behind_square_integrable : ex_RInt (fun t => behind t ^ 2) 0 1.
Proof. apply ex_RInt_cont. intro t. apply continuous_square, (behind_continuous _ _ covers). Qed.

Lemma mean_nonneg : 0 <= m.
Proof.
  apply RInt_ge_0; [lra | apply behind_integrable | intros; apply (behind_nonneg _ _ covers)].
Qed.

Lemma variance_nonneg : 0 <= Var.
Proof.
  assert (Q : is_RInt (fun t => behind t ^ 2 + (- (2 * m) * behind t + m ^ 2)) 0 1
                (second + (- (2 * m) * m + (1 - 0) * m ^ 2))).
  { apply (@is_RInt_plus R_NormedModule (fun t => behind t ^ 2)).
    - apply RInt_is, behind_square_integrable.
    - apply (@is_RInt_plus R_NormedModule (fun t => - (2 * m) * behind t)).
      + apply (@is_RInt_scal R_NormedModule), RInt_is, behind_integrable.
      + apply (@is_RInt_const R_NormedModule). }
  apply is_RInt_ge_0 in Q; [| lra | intros t _; pose proof (pow2_ge_0 (behind t - m)); lra].
  unfold Var, variance_of. fold m second. lra.
Qed.

(** The weight of Schur's test. *)
Let nu := sqrt ((1 / 2 + m) ^ 2 + Var).
Let weight (t : R) : R := (nu + 1 / 2) + behind t.

Lemma nu_square : nu * nu = (1 / 2 + m) ^ 2 + Var.
Proof.
  apply sqrt_sqrt. pose proof variance_nonneg. pose proof (pow2_ge_0 (1 / 2 + m)). lra.
Qed.

Lemma phase_weight_continuous : forall t, continuous weight t.
Proof.
  intro t. apply continuous_Rplus; [apply continuous_const | apply (behind_continuous _ _ covers)].
Qed.

Lemma phase_weight_positive : forall t, 0 < weight t.
Proof.
  intro t. unfold weight. pose proof (behind_nonneg _ _ covers t).
  assert (0 <= nu) by apply sqrt_pos. lra.
Qed.

Lemma weight_total : phase_mass weight (fun _ => 1) = nu + 1 / 2 + m.
Proof.
  apply is_RInt_unique. apply is_RInt_ext with weight; [intros; over_R; ring |].
  replace (nu + 1 / 2 + m) with ((1 - 0) * (nu + 1 / 2) + m) by ring.
  apply (@is_RInt_plus R_NormedModule (fun _ => nu + 1 / 2) behind).
  - apply (@is_RInt_const R_NormedModule).
  - apply RInt_is, behind_integrable.
Qed.

Lemma weight_behind : phase_mass weight behind = (nu + 1 / 2) * m + second.
Proof.
  apply is_RInt_unique.
  apply is_RInt_ext with (fun t => (nu + 1 / 2) * behind t + behind t ^ 2);
    [intros; unfold weight; over_R; ring |].
  apply (@is_RInt_plus R_NormedModule (fun t => (nu + 1 / 2) * behind t)).
  - apply (@is_RInt_scal R_NormedModule), RInt_is, behind_integrable.
  - apply RInt_is, behind_square_integrable.
Qed.

Lemma weight_shares : (forall x, continuous late x) -> forall N,
  sum_to N (fun j => phase_mass weight (fun t => late (INR (pred j) + t)))
  <= phase_mass weight behind.
Proof.
  intros Lc N.
  assert (C : forall j t, continuous (fun t => late (INR (pred j) + t) * weight t) t).
  { intros j t. apply continuous_Rmult; [| apply phase_weight_continuous].
    apply (continuous_comp (fun t => INR (pred j) + t) late); [| apply Lc].
    apply (ex_derive_continuous (fun t => INR (pred j) + t)). auto_derive. exact I. }
  unfold phase_mass at 1.
  rewrite <- (is_RInt_unique _ _ _ _ (RInt_sum_to N (fun j t => late (INR (pred j) + t) * weight t)
    0 1 (fun j => ex_RInt_cont _ 0 1 (C j)))).
  apply RInt_le; [lra | | |].
  - apply ex_RInt_cont. intro t. apply continuous_sum_to. intro j. apply C.
  - apply ex_RInt_cont. intro t. apply continuous_Rmult;
      [apply (behind_continuous _ _ covers) | apply phase_weight_continuous].
  - intros t Ht.
    rewrite (sum_to_ext N _ (fun j => weight t * late (INR (pred j) + t))) by (intros; ring).
    rewrite sum_to_scal, Rmult_comm. apply Rmult_le_compat_r.
    + apply Rlt_le, phase_weight_positive.
    + apply (behind_all _ _ covers). lra.
Qed.

(** With this weight Schur's test gives exactly kappa. *)
Lemma weight_schur : forall kappa N t, actuator_cost m Var <= kappa -> 0 <= t <= 1 ->
  phase_mass weight (fun _ => 1) / 2 * (1 + sum_to N (fun j => late (INR (pred j) + t)))
  + phase_mass weight behind / 2 <= kappa * weight t.
Proof.
  intros kappa N t Hk Ht. rewrite weight_total, weight_behind.
  pose proof (behind_all _ _ covers N t Ht) as A. pose proof nu_square as Sq.
  assert (N0 : 0 <= nu) by apply sqrt_pos. pose proof mean_nonneg as M0.
  assert (S2 : second = Var + m ^ 2) by (unfold Var, variance_of; fold m second; over_R; ring).
  assert (Kw : actuator_cost m Var * weight t <= kappa * weight t)
    by (apply Rmult_le_compat_r; [apply Rlt_le, phase_weight_positive | exact Hk]).
  eapply Rle_trans; [| exact Kw]. unfold actuator_cost. fold nu. rewrite S2. unfold weight.
  set (s := sum_to N (fun j => late (INR (pred j) + t))) in *.
  clearbody s second. clear S2.
  assert ((nu + 1 / 2 + m) * s <= (nu + 1 / 2 + m) * behind t)
    by (apply Rmult_le_compat_l; lra).
  nra.
Qed.

End Moments.

Section Actuator.

Variables mu beta sigma kappa : R.
Variables pos vel friction hand force late behind : R -> R.
Variables (one_sided : bool) (force_step limit : option R) (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis step_ok : step_positive force_step.
Hypothesis limit_ok : limit_nonneg limit.
(** With an encoder [measured] and 1/2; without one the identity and 0. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
Hypothesis delays : only_delays late.
Hypothesis covers : behind_covers late behind.
(** [kappa] is enough for the mean and the variance (TH_LAG_kappa_squares). *)
Hypothesis enough_mean : 0 <= spare_mean kappa (mean_of behind).
Hypothesis enough_square : 0 <= spare_square kappa (mean_of behind) (variance_of behind).

(** The program's command at a sample: one-sided or not, rounded, limited. *)
Definition wall_command (h : nat) : R :=
  let q := measure (pos (INR h)) in controller one_sided 0 force_step limit q q.

Hypothesis O : obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t).
Hypothesis acts : actuates late wall_command force.

Let f := controller_law one_sided limit.
Let V := controller_potential one_sided limit.
Let coulomb := e + step_size force_step / 2.
Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.
Let phases (n : nat) (t : R) : R := late (INR n + t).

Lemma wall_command_error : forall h, Rabs (wall_command h + f (pos (INR h))) <= coulomb.
Proof.
  intro h. unfold wall_command. set (x := pos (INR h)). set (q := measure x).
  pose proof (controller_commands one_sided 0 force_step limit q q (Rle_refl 0) step_ok limit_ok) as C.
  unfold commands in C. fold f in C. rewrite Rmult_0_l, Rplus_0_l in C.
  pose proof (controller_law_lipschitz one_sided limit q x) as L. fold f in L.
  pose proof (measure_error x) as M. fold q in M.
  set (F := controller one_sided 0 force_step limit q q) in *.
  replace (F + f x) with (- (- F - f q) + - (f q - f x)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite !Rabs_Ropp. unfold coulomb. lra.
Qed.

(** No sample is farther away than the way since. *)
Lemma sample_distance : forall h t n, INR h <= t -> (n <= h)%nat ->
  Rabs (pos t - pos (INR (h - n)))
  <= way vel (INR h) t + sum_to n (fun j => way vel (INR (h - j)) (INR (S (h - j)))).
Proof.
  intros h t n Ht. induction n as [| n IH]; intro Hn.
  - simpl. rewrite Nat.sub_0_r, Rplus_0_r. apply (way_at_least pos vel K). exact Ht.
  - specialize (IH ltac:(lia)). rewrite sum_to_S.
    replace (S (h - S n)) with (h - n)%nat by lia.
    pose proof (way_at_least pos vel K (INR (h - S n)) (INR (h - n))
      ltac:(apply le_INR; lia)) as Wy.
    fold (way vel (INR (h - S n)) (INR (h - n))) in Wy.
    replace (pos t - pos (INR (h - S n)))
      with ((pos t - pos (INR (h - n))) + (pos (INR (h - n)) - pos (INR (h - S n)))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. lra.
Qed.

Lemma actuator_close : forall h t, INR h < t < INR (S h) ->
  Rabs (force t + f (pos t)) <= behind_at_most vel phases h t + coulomb.
Proof.
  intros h t Ht. rewrite (acts h t Ht). rewrite S_INR in Ht.
  set (s := fun n => late (INR n + (t - INR h))).
  set (b := fun n => wall_command (h - n) + f (pos t)).
  set (B := fun n => way vel (INR h) t
    + sum_to n (fun j => way vel (INR (h - j)) (INR (S (h - j)))) + coulomb).
  pose proof (falling_mean s b B h) as M.
  assert (E1 : superposed late wall_command h t + f (pos t)
    = b 0%nat - sum_to h (fun j => s (pred j) * (b (pred j) - b j))).
  { assert (Sx : sum_to h (fun j => s (pred j) * (b (pred j) - b j))
      = sum_to h (fun j => late (INR (pred j) + (t - INR h))
          * (wall_command (h - pred j) - wall_command (h - j))))
      by (apply sum_to_ext; intros; unfold s, b; ring).
    rewrite Sx. unfold superposed, b. rewrite Nat.sub_0_r. ring. }
  assert (E2 : behind_at_most vel phases h t + coulomb
    = B 0%nat - sum_to h (fun j => s (pred j) * (B (pred j) - B j))).
  { assert (Sx : sum_to h (fun j => s (pred j) * (B (pred j) - B j))
      = sum_to h (fun j => - 1 * (phases (pred j) (t - INR h)
          * way vel (INR (h - j)) (INR (S (h - j)))))).
    { apply sum_to_ext. intros [| j] Hj; [lia |]. simpl pred. unfold B. rewrite sum_to_S.
      unfold s, phases. ring. }
    rewrite Sx, sum_to_scal. unfold behind_at_most, B. simpl (sum_to 0 _). ring. }
  rewrite E1, E2. apply M.
  - intro n. unfold s. apply (late_falls _ delays). rewrite S_INR. lra.
  - intro n. apply (late_share _ delays).
  - intros n Hn. unfold b, B.
    replace (wall_command (h - n) + f (pos t))
      with ((wall_command (h - n) + f (pos (INR (h - n)))) + (f (pos t) - f (pos (INR (h - n)))))
      by ring.
    eapply Rle_trans; [apply Rabs_triang |].
    pose proof (wall_command_error (h - n)).
    pose proof (controller_law_lipschitz one_sided limit (pos t) (pos (INR (h - n)))) as L.
    fold f in L. pose proof (sample_distance h t n ltac:(lra) Hn). lra.
Qed.

Lemma actuator_work_integrable : forall h s t, INR h <= s <= t -> t <= INR (S h) ->
  ex_RInt (fun u => force u * vel u) s t.
Proof.
  intros h s t H1 H2. apply ex_RInt_ext with (fun u => superposed late wall_command h u * vel u).
  - intros u Hu. rewrite Rmin_left, Rmax_right in Hu by lra.
    rewrite (acts h u) by lra. reflexivity.
  - apply ex_RInt_cont. intro u. apply continuous_Rmult; [| apply (velocity_continuous _ _ K)].
    unfold superposed.
    apply (continuous_minus (fun _ => wall_command h)); [apply continuous_const |].
    apply continuous_sum_to. intro j. apply continuous_Rmult; [| apply continuous_const].
    apply (continuous_comp (fun t => INR (pred j) + (t - INR h)) late);
      [| apply (late_is_continuous _ delays)].
    apply (ex_derive_continuous (fun t => INR (pred j) + (t - INR h))). auto_derive. exact I.
Qed.

(** TH-LAG (any actuator): the criterion is (beta - kappa)|v| + (sigma - e - delta/2) >= 0, for the
    wall and for the one that is one-sided or saturated. *)
Theorem TH_LAG_actuator : forall t, 0 <= t ->
  criterion_holds (beta - kappa) (sigma - coulomb) vel t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0)) (kinetic mu (vel t) + V (pos t)) t.
Proof.
  set (nu := sqrt ((1 / 2 + mean_of behind) ^ 2 + variance_of behind)).
  set (weight := fun t => (nu + 1 / 2) + behind t).
  assert (Ph : forall n t, continuous (phases n) t).
  { intros n t. apply (continuous_comp (fun t => INR n + t) late);
      [| apply (late_is_continuous _ delays)].
    apply (ex_derive_continuous (fun t => INR n + t)). auto_derive. exact I. }
  apply (positive_run mu beta sigma kappa coulomb (phase_mass weight behind) pos vel friction hand
    force f V weight phases P O).
  - intro x. apply continuity_pt_filterlim. intros eps He. exists eps. split; [exact He |].
    intros z [_ Hz]. eapply Rle_lt_trans; [apply controller_law_lipschitz | exact Hz].
  - apply controller_law_potential, limit_ok.
  - exact Ph.
  - intros n t _. apply (late_share _ delays).
  - exact (phase_weight_continuous late behind covers).
  - exact (phase_weight_positive late behind covers).
  - exact (weight_shares late behind covers (late_is_continuous _ delays)).
  - intros N t Ht. apply (weight_schur late behind covers); [| exact Ht].
    apply TH_LAG_kappa_squares; [apply (mean_nonneg late behind covers)
      | apply (variance_nonneg late behind covers) | split; assumption].
  - exact actuator_work_integrable.
  - exact actuator_close.
Qed.

End Actuator.
