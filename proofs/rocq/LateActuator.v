(** * LateActuator: TH-LAG for any actuator that only delays, under the laws of the product.

    [late x] is the share of a step of the command that has not reached the device x periods
    after its sample: from 1 down to 0, never up.  [behind t] is what is late at phase t, of all
    samples; m is its mean over the phases and Var its variance. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller ActuatorCost InstantRun Weighted Angles LinearController
  FiniteResponse GatedController PositiveKernel PositiveActuator DelayedTails.
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
Variables past c : nat -> R.
Variables (n : nat) (one_sided : bool) (force_step limit : option R) (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis step_ok : step_positive force_step.
Hypothesis limit_ok : limit_nonneg limit.
(** With an encoder [measured] and 1/2; without one the identity and 0.  Either tells the side. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
Hypothesis measure_side : forall x, measure x < 0 <-> x < 0.
Hypothesis sum_nonneg : 0 <= tail c n 0.
Hypothesis delays : only_delays late.
Hypothesis covers : behind_covers late behind.
(** [kappa] is enough for the mean and the variance (TH_LAG_kappa_squares). *)
Hypothesis enough_mean : 0 <= spare_mean kappa (mean_of behind).
Hypothesis enough_square : 0 <= spare_square kappa (mean_of behind) (variance_of behind).
(** The device had rested. *)
Hypothesis rested : forall j, past j = pos 0.

Hypothesis O : obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t).
(** The commands are the program's (GatedController.v). *)
Let u := held_by_gated pos past c n 0 one_sided force_step limit measure.
Hypothesis acts : actuates late u force.

Let H := tail c n 0.
Let f (x : R) : R := controller_law one_sided limit (H * x).
Let V := scaled_potential H one_sided limit.
Let a (j : nat) : R := Rabs (tail c n j).
Let coulomb := e * response_norm c n + step_size force_step / 2.
Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.
Let phases (m : nat) (t : R) : R := late (INR m + t).
Let full (i : nat) : R := way vel (INR i) (INR (S i)).

Lemma law_stiffness : forall x y, Rabs (f x - f y) <= H * Rabs (x - y).
Proof.
  intros x y. unfold f. eapply Rle_trans; [apply controller_law_lipschitz |].
  rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_right H) by (apply Rle_ge, sum_nonneg). lra.
Qed.

(** A step before the start is none, a later one no longer than its way. *)
Lemma step_way : forall i j, (1 <= j)%nat -> Rabs (step INR pos past i j) <= heard_way vel i j.
Proof.
  intros i j Hj. unfold step, heard_way, sample.
  destruct (Nat.leb_spec j i) as [L | L]; destruct (Nat.leb_spec (pred j) i) as [L' | L']; try lia.
  - pose proof (way_at_least pos vel K (INR (i - j)) (INR (S (i - j)))
      ltac:(rewrite S_INR; lra)) as W.
    replace (i - pred j)%nat with (S (i - j)) by lia. exact W.
  - replace (i - pred j)%nat with 0%nat by lia. rewrite rested. simpl (INR 0).
    replace (pos 0 - pos 0) with 0 by ring. rewrite Rabs_R0. lra.
  - rewrite !rested. replace (pos 0 - pos 0) with 0 by ring. rewrite Rabs_R0. lra.
Qed.

Lemma actuator_command : forall i,
  Rabs (u i + f (pos (INR i))) <= sum_to n (fun j => a j * heard_way vel i j) + coulomb.
Proof.
  intro i. pose proof (gated_commanded pos past c n 0 one_sided force_step limit measure e step_ok
    limit_ok measure_error measure_side sum_nonneg i) as C.
  simpl (sum_to 0 _) in C. rewrite Rmult_0_r, Rplus_0_l in C.
  eapply Rle_trans; [exact C |]. apply Rplus_le_compat_r. apply sum_to_le. intros j Hj.
  apply Rmult_le_compat_l; [apply Rabs_pos | apply step_way; lia].
Qed.

(** No sample is farther away than the way since. *)
Lemma sample_distance : forall h t m, INR h <= t -> (m <= h)%nat ->
  Rabs (pos t - pos (INR (h - m)))
  <= way vel (INR h) t + sum_to m (fun j => full (h - j)).
Proof.
  intros h t m Ht. induction m as [| m IH]; intro Hm.
  - simpl. rewrite Nat.sub_0_r, Rplus_0_r. apply (way_at_least pos vel K). exact Ht.
  - specialize (IH ltac:(lia)). rewrite sum_to_S. unfold full at 2.
    replace (S (h - S m)) with (h - m)%nat by lia.
    pose proof (way_at_least pos vel K (INR (h - S m)) (INR (h - m))
      ltac:(apply le_INR; lia)) as Wy.
    fold (way vel (INR (h - S m)) (INR (h - m))) in Wy.
    replace (pos t - pos (INR (h - S m)))
      with ((pos t - pos (INR (h - m))) + (pos (INR (h - m)) - pos (INR (h - S m)))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. lra.
Qed.

Lemma actuator_close : forall h t, INR h < t < INR (S h) ->
  Rabs (force t + f (pos t))
  <= H * (way vel (INR h) t + ways_before vel phases h t) + tails_extra late vel a n h t + coulomb.
Proof.
  intros h t Ht. rewrite (acts h t Ht). rewrite S_INR in Ht.
  set (s := fun m => late (INR m + (t - INR h))).
  set (b := fun m => u (h - m)%nat + f (pos t)).
  set (y := fun m => sum_to n (fun j => a j * heard_way vel (h - m) j)).
  set (B := fun m => H * (way vel (INR h) t + sum_to m (fun j => full (h - j))) + y m + coulomb).
  pose proof (falling_mean s b B h) as M.
  assert (E1 : superposed late u h t + f (pos t)
    = b 0%nat - sum_to h (fun j => s (pred j) * (b (pred j) - b j))).
  { assert (Sx : sum_to h (fun j => s (pred j) * (b (pred j) - b j))
      = sum_to h (fun j => late (INR (pred j) + (t - INR h))
          * (u (h - pred j)%nat - u (h - j)%nat)))
      by (apply sum_to_ext; intros; unfold s, b; ring).
    rewrite Sx. unfold superposed, b. rewrite Nat.sub_0_r. ring. }
  assert (Ex : y 0%nat - sum_to h (fun i => s (pred i) * (y (pred i) - y i))
               = tails_extra late vel a n h t).
  { unfold tails_extra.
    rewrite (sum_to_ext n (fun j => a j * ways_before vel (tail_kernel late j) h t)
      (fun j => a j * heard_way vel h j + - 1 * sum_to h (fun i => a j * (s (pred i)
        * (heard_way vel (h - pred i) j - heard_way vel (h - i) j))))).
    - rewrite sum_to_plus, sum_to_scal, sum_to_swap. unfold y at 1. rewrite Nat.sub_0_r.
      rewrite (sum_to_ext h (fun i => s (pred i) * (y (pred i) - y i)) (fun i => sum_to n (fun j =>
        a j * (s (pred i) * (heard_way vel (h - pred i) j - heard_way vel (h - i) j))))); [ring |].
      intros i _. unfold y.
      rewrite (sum_to_ext n (fun j => a j * (s (pred i) * _)) (fun j => s (pred i)
        * (a j * heard_way vel (h - pred i) j + - 1 * (a j * heard_way vel (h - i) j))))
        by (intros; ring).
      rewrite sum_to_scal, sum_to_plus, sum_to_scal. ring.
    - intros j Hj. rewrite <- (tail_ways late vel j h t) by lia. rewrite sum_to_scal.
      unfold s. ring. }
  assert (E2 : H * (way vel (INR h) t + ways_before vel phases h t) + tails_extra late vel a n h t
      + coulomb = B 0%nat - sum_to h (fun j => s (pred j) * (B (pred j) - B j))).
  { assert (Sx : sum_to h (fun j => s (pred j) * (B (pred j) - B j))
      = - H * ways_before vel phases h t + sum_to h (fun i => s (pred i) * (y (pred i) - y i))).
    { unfold ways_before. rewrite <- sum_to_scal, <- sum_to_plus. apply sum_to_ext.
      intros [| j] Hj; [lia |]. simpl pred. unfold B. rewrite sum_to_S.
      unfold s, phases, full. ring. }
    rewrite Sx, <- Ex. unfold B. simpl (sum_to 0 _). ring. }
  rewrite E1, E2. apply M.
  - intro m. unfold s. apply (late_falls _ delays). rewrite S_INR. lra.
  - intro m. apply (late_share _ delays).
  - intros m Hm. unfold b, B, y.
    replace (u (h - m)%nat + f (pos t))
      with ((f (pos t) - f (pos (INR (h - m)))) + (u (h - m)%nat + f (pos (INR (h - m))))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. rewrite Rplus_assoc. apply Rplus_le_compat.
    + eapply Rle_trans; [apply law_stiffness |].
      apply Rmult_le_compat_l; [exact sum_nonneg | apply sample_distance; lra || exact Hm].
    + apply actuator_command.
Qed.

Lemma actuator_work_integrable : forall h s t, INR h <= s <= t -> t <= INR (S h) ->
  ex_RInt (fun v => force v * vel v) s t.
Proof.
  intros h s t H1 H2. apply ex_RInt_ext with (fun v => superposed late u h v * vel v).
  - intros v Hv. rewrite Rmin_left, Rmax_right in Hv by lra.
    rewrite (acts h v) by lra. reflexivity.
  - apply ex_RInt_cont. intro v. apply continuous_Rmult; [| apply (velocity_continuous _ _ K)].
    unfold superposed.
    apply (continuous_minus (fun _ => u h)); [apply continuous_const |].
    apply continuous_sum_to. intro j. apply continuous_Rmult; [| apply continuous_const].
    apply (continuous_comp (fun t => INR (pred j) + (t - INR h)) late);
      [| apply (late_is_continuous _ delays)].
    apply (ex_derive_continuous (fun t => INR (pred j) + (t - INR h))). auto_derive. exact I.
Qed.

Lemma law_is_continuous : forall x, continuous f x.
Proof.
  intro x. apply (continuous_comp (fun x => H * x) (controller_law one_sided limit)).
  - apply continuous_Rmult; [apply continuous_const | apply continuous_id].
  - apply continuity_pt_filterlim. intros eps He. exists eps. split; [exact He |].
    intros z [_ Hz]. eapply Rle_lt_trans; [apply controller_law_lipschitz | exact Hz].
Qed.

(** TH-LAG (any controller, any actuator): with the tails g_1, ..., g_n the criterion is
    (beta - H(1) kappa - |g_1| - ... - |g_n|)|v| + (sigma - e|c|_1 - delta/2) >= 0, for the wall and
    for the one that is one-sided or saturated; after rest. *)
Theorem TH_LAG_actuator : forall t, 0 <= t ->
  criterion_holds (beta - (H * kappa + tails_norm (tail c n) n)) (sigma - coulomb) vel t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0)) (kinetic mu (vel t) + V (pos t)) t.
Proof.
  set (nu := sqrt ((1 / 2 + mean_of behind) ^ 2 + variance_of behind)).
  set (weight := fun t => (nu + 1 / 2) + behind t).
  assert (Ph : forall m t, continuous (phases m) t).
  { intros m t. apply (continuous_comp (fun t => INR m + t) late);
      [| apply (late_is_continuous _ delays)].
    apply (ex_derive_continuous (fun t => INR m + t)). auto_derive. exact I. }
  pose proof (late_is_continuous _ delays) as Lc. pose proof (late_falls _ delays) as Lf.
  pose proof (late_share _ delays) as Ls.
  assert (A0 : forall j, 0 <= a j) by (intro; apply Rabs_pos).
  apply (positive_run mu beta sigma H kappa (sum_to n a) coulomb (phase_mass weight behind)
    pos vel friction hand force f V weight phases (tails_extra late vel a n)
    (tails_held late vel a n) (tails_towards late vel a n) P O sum_nonneg law_is_continuous
    (scaled_derivative H one_sided limit sum_nonneg limit_ok) Ph).
  - intros m t _. apply Ls.
  - exact (phase_weight_continuous late behind covers).
  - exact (phase_weight_positive late behind covers).
  - exact (weight_shares late behind covers Lc).
  - intros N t Ht. apply (weight_schur late behind covers); [| exact Ht].
    apply TH_LAG_kappa_squares; [apply (mean_nonneg late behind covers)
      | apply (variance_nonneg late behind covers) | split; assumption].
  - exact actuator_work_integrable.
  - intros h t Ht. eexists. apply (tails_integrable late Lc pos vel a n K h t Ht).
  - exact (tails_paid late Lc Lf Ls pos vel a n K A0).
  - apply tails_arrive.
  - apply (tails_towards_nonneg late Lc Lf Ls pos vel a n K A0).
  - apply tails_start.
  - exact actuator_close.
Qed.

End Actuator.
