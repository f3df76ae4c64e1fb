(** * LatencyController: TH-LATENCY behind any controller, under one-sided and saturated walls.

    The command of sample h acts from h + k + f on, 0 < f < 1, without a lag.  The same square as
    in Latency.v, with the ways |v| in place of the displacements; the tails of the controller cost
    their absolute values.  The device had rested. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Calculus Model History Law Combined Passivity Laws Effects
  Controller ActuatorCost InstantRun Weighted Angles FiniteResponse GatedController PositiveKernel
  DelayedTails LateActuator.
Open Scope R_scope.

(** The force of a latency: the command k + 1 samples ago, and from f on the one k samples ago. *)
Definition acts_late (k : nat) (f : R) (u : nat -> R) (force : R -> R) : Prop :=
  forall h t,
  (INR h < t < INR h + f -> force t = u (h - S k)%nat) /\
  (INR h + f < t < INR (S h) -> force t = u (h - k)%nat).

(** What a tail remembers: [s] are the ways before, each charged f and 1 - f of itself. *)
Definition tail_squares (k : nat) (f : R) (j : nat) (s : nat -> R) : R :=
  (sum_to (k + j) (fun i => s i ^ 2) + f * s (S (k + j)) ^ 2) / 2.

Lemma tail_squares_push : forall k f j d s, (1 <= j)%nat ->
  tail_squares k f j (push d s) - tail_squares k f j s
  = (d ^ 2 - (1 - f) * s (k + j)%nat ^ 2 - f * s (S (k + j)) ^ 2) / 2.
Proof.
  intros k f j d s Hj. unfold tail_squares.
  destruct j as [| j]; [lia |]. replace (k + S j)%nat with (S (k + j)) by lia.
  rewrite sum_to_first. simpl (push d s 1). simpl (push d s (S (S (k + j)))).
  rewrite (sum_to_ext (k + j) (fun i => push d s (S i) ^ 2) (fun i => s i ^ 2))
    by (intros [| i] Hi; [lia | reflexivity]).
  rewrite sum_to_S. field.
Qed.

Lemma tail_squares_nonneg : forall k f j s, 0 <= f -> 0 <= tail_squares k f j s.
Proof.
  intros k f j s Hf. unfold tail_squares.
  assert (0 <= sum_to (k + j) (fun i => s i ^ 2)) by (apply sum_to_nonneg; intros; apply pow2_ge_0).
  pose proof (pow2_ge_0 (s (S (k + j)))). nra.
Qed.

Section LatencyController.

Variables mu beta sigma kappa : R.
Variables pos vel friction hand force : R -> R.
Variables past c : nat -> R.
Variables (n k : nat) (f : R).
Variables (one_sided : bool) (force_step limit : option R) (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis f_between : 0 < f < 1.
Hypothesis step_ok : step_positive force_step.
Hypothesis limit_ok : limit_nonneg limit.
(** With an encoder [measured] and 1/2; without one the identity and 0.  Either tells the side. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
Hypothesis measure_side : forall x, measure x < 0 <-> x < 0.
Hypothesis sum_nonneg : 0 <= tail c n 0.
(** [kappa] is enough (TH_LAG_kappa_squares). *)
Hypothesis enough_mean : 0 <= spare_mean kappa (INR k + f).
Hypothesis enough_square : 0 <= spare_square kappa (INR k + f) (latency_variance f).
(** The device had rested. *)
Hypothesis rested : forall j, past j = pos 0.
Hypothesis O : obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t).
Let u := held_by_gated pos past c n 0 one_sided force_step limit measure.
Hypothesis acts : acts_late k f u force.

Let H := tail c n 0.
Let law (x : R) : R := controller_law one_sided limit (H * x).
Let V := scaled_potential H one_sided limit.
Let a (j : nat) : R := Rabs (tail c n j).
Let coulomb := e * response_norm c n + step_size force_step / 2.
Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.
Let s (h : nat) : nat -> R := heard_way vel h.
Let far (h m : nat) : R := sum_to m (s h).
Let tails (h m : nat) : R := sum_to n (fun j => a j * s h (m + j)%nat).

Lemma way_pos : forall x y, x <= y -> 0 <= way vel x y.
Proof.
  intros x y L. apply RInt_ge_0; [exact L | apply (speed_integrable pos vel K) |].
  intros. apply Rabs_pos.
Qed.

Lemma heard_pos : forall h j, 0 <= s h j.
Proof.
  intros h j. unfold s, heard_way. destruct (Nat.leb j h); [| lra].
  apply way_pos. rewrite S_INR. lra.
Qed.

Lemma way_split : forall x y z, way vel x z = way vel x y + way vel y z.
Proof. intros. unfold way. apply RInt_split; apply (speed_integrable pos vel K). Qed.

(** The command m samples ago against the law now. *)
Lemma late_command : forall h m t, INR h <= t ->
  Rabs (u (h - m)%nat + law (pos t)) <= H * (way vel (INR h) t + far h m) + tails h m + coulomb.
Proof.
  intros h m t Ht.
  pose proof (actuator_command mu beta sigma pos vel friction hand force past c n one_sided
    force_step limit measure e step_ok limit_ok measure_error measure_side sum_nonneg rested O
    (h - m)) as C.
  change (Rabs (u (h - m)%nat + law (pos (INR (h - m))))
    <= sum_to n (fun j => a j * heard_way vel (h - m) j) + coulomb) in C.
  assert (T : sum_to n (fun j => a j * heard_way vel (h - m) j) <= tails h m).
  { unfold tails. apply sum_to_le. intros j Hj. apply Rmult_le_compat_l; [apply Rabs_pos |].
    unfold s, heard_way. destruct (Nat.leb_spec j (h - m)) as [L | L].
    - destruct (Nat.leb_spec (m + j) h); [| lia].
      replace (h - (m + j))%nat with (h - m - j)%nat by lia. lra.
    - destruct (Nat.leb_spec (m + j) h); [lia | lra]. }
  assert (D : Rabs (pos t - pos (INR (h - m))) <= way vel (INR h) t + far h m).
  { set (m' := Nat.min m h). replace (h - m)%nat with (h - m')%nat by (unfold m'; lia).
    pose proof (sample_distance mu beta sigma pos vel friction hand force O h t m' Ht
      ltac:(unfold m'; lia)) as S1.
    assert (F : sum_to m' (fun j => way vel (INR (h - j)) (INR (S (h - j)))) = sum_to m' (s h)).
    { apply sum_to_ext. intros j Hj. unfold s, heard_way.
      destruct (Nat.leb_spec j h); [reflexivity | unfold m' in Hj; lia]. }
    cbv beta in S1. rewrite F in S1. assert (G : sum_to m' (s h) <= far h m).
    { unfold far. destruct (Nat.le_gt_cases m h).
      - replace m' with m by (unfold m'; lia). lra.
      - rewrite (sum_to_extend m' m); [lra | unfold m'; lia |].
        intros j Hj. unfold s, heard_way. destruct (Nat.leb_spec j h); [unfold m' in Hj; lia | reflexivity]. }
    lra. }
  pose proof (law_stiffness c n one_sided limit sum_nonneg (pos t) (pos (INR (h - m)))) as L.
  fold H in L. change (Rabs (law (pos t) - law (pos (INR (h - m))))
    <= H * Rabs (pos t - pos (INR (h - m)))) in L.
  apply (Rmult_le_compat_l H) in D; [| exact sum_nonneg].
  replace (u (h - m)%nat + law (pos t))
    with ((law (pos t) - law (pos (INR (h - m)))) + (u (h - m)%nat + law (pos (INR (h - m))))) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. lra.
Qed.

(** Work of a force that is held from [x] on, as far from the law as the way since and [C]. *)
Lemma held_work : forall F C x t, x <= t ->
  (forall v, x < v < t -> force v = F) ->
  (forall v, x < v < t -> Rabs (F + law (pos v)) <= H * way vel x v + C) ->
  is_RInt (fun v => force v * vel v) x t (F * (pos t - pos x)) /\
  F * (pos t - pos x) + (V (pos t) - V (pos x)) <= H * (way vel x t ^ 2 / 2) + C * way vel x t.
Proof.
  intros F C x t xt Fh Fc.
  assert (If : is_RInt (fun v => F * vel v) x t (F * (pos t - pos x)))
    by (apply (@is_RInt_scal R_NormedModule), (vel_integral pos vel K)).
  split.
  { apply is_RInt_ext with (2 := If). intros v Hv. rewrite Rmin_left, Rmax_right in Hv by lra.
    rewrite (Fh v Hv). reflexivity. }
  assert (Cp : forall v, continuous (fun v => law (pos v) * vel v) v).
  { intro v. apply continuous_Rmult; [| apply (velocity_continuous _ _ K)].
    apply (continuous_comp pos law); [apply (pos_continuous _ _ K) |].
    apply (law_is_continuous c n one_sided limit). }
  assert (Iv : is_RInt (fun v => law (pos v) * vel v) x t (V (pos t) - V (pos x))).
  { apply (is_RInt_primitive (fun v => V (pos v))); [| exact Cp].
    intro v. pose proof (is_derive_comp V pos v (law (pos v)) (vel v)
      (scaled_derivative H one_sided limit sum_nonneg limit_ok (pos v))
      (velocity_is_derivative _ _ K v)) as D.
    rewrite Rmult_comm. exact D. }
  assert (Dw : forall v, is_derive (way vel x) v (Rabs (vel v))).
  { intro v. apply (is_derive_RInt (fun v => Rabs (vel v)) (way vel x) x).
    - apply filter_forall. intro y. apply RInt_is, (speed_integrable pos vel K).
    - apply continuous_Rabs, (velocity_continuous _ _ K). }
  assert (Iw : is_RInt (fun v => Rabs (vel v) * way vel x v) x t (way vel x t ^ 2 / 2)).
  { replace (way vel x t ^ 2 / 2) with (way vel x t ^ 2 / 2 - way vel x x ^ 2 / 2).
    - apply (is_RInt_primitive (fun v => way vel x v ^ 2 / 2)).
      + intro v. pose proof (Dw v) as Dv. auto_derive.
        * exists (Rabs (vel v)). exact Dv.
        * replace (Derive (fun y => way vel x y) v) with (Rabs (vel v))
            by (symmetry; apply is_derive_unique; exact Dv). field.
      + intro v. apply continuous_Rmult; [apply continuous_Rabs, (velocity_continuous _ _ K) |].
        apply (ex_derive_continuous (way vel x)). exists (Rabs (vel v)). apply Dw.
    - unfold way at 2. rewrite RInt_point. change zero with 0. field. }
  apply (is_RInt_le (fun v => F * vel v + law (pos v) * vel v)
    (fun v => H * (Rabs (vel v) * way vel x v) + C * Rabs (vel v)) x t _ _ xt).
  - apply (@is_RInt_plus R_NormedModule (fun v => F * vel v)); [exact If | exact Iv].
  - apply (@is_RInt_plus R_NormedModule (fun v => H * (Rabs (vel v) * way vel x v))).
    + apply (@is_RInt_scal R_NormedModule), Iw.
    + apply (@is_RInt_scal R_NormedModule), RInt_is, (speed_integrable pos vel K).
  - intros v Hv. specialize (Fc v Hv).
    replace (F * vel v + law (pos v) * vel v) with ((F + law (pos v)) * vel v) by ring.
    eapply Rle_trans; [apply Rle_abs |]. rewrite Rabs_mult.
    apply (Rmult_le_compat_r (Rabs (vel v))) in Fc; [| apply Rabs_pos]. lra.
Qed.

(** A way takes at least its square by the time of the squared velocity. *)
Lemma way_at_most : forall x t tau, x <= t -> t - x <= tau -> 0 < tau ->
  way vel x t ^ 2 / tau <= square_integral vel x t.
Proof.
  intros x t tau xt Ht T0.
  pose proof (weighted_squares (fun v => Rabs (vel v)) (fun _ => 1) (fun _ => 1) x t xt
    (fun v => continuous_Rabs vel v (velocity_continuous _ _ K v)) (fun v => continuous_const 1 v)
    (fun v => continuous_const 1 v) (fun _ => Rlt_0_1) (fun _ _ => Rle_0_1)) as Wq.
  assert (E1 : RInt (fun v => Rabs (vel v) * 1) x t = way vel x t)
    by (apply RInt_ext; intros; apply Rmult_1_r).
  assert (E2 : RInt (fun v => Rabs (vel v) ^ 2 * 1 / 1) x t = square_integral vel x t)
    by (apply RInt_ext; intros; rewrite pow2_abs; over_R; field).
  assert (E3 : RInt (fun v => 1 * 1) x t = t - x).
  { apply is_RInt_unique. evar_last; [apply (@is_RInt_const R_NormedModule) |].
    unfold scal. simpl. unfold mult. simpl. over_R. ring. }
  cbv beta in Wq. rewrite E1, E2, E3 in Wq.
  assert (Q0 : 0 <= square_integral vel x t).
  { apply RInt_ge_0; [exact xt | apply (square_integrable pos vel K) | intros; apply pow2_ge_0]. }
  apply Rmult_le_reg_r with tau; [exact T0 |].
  replace (way vel x t ^ 2 / tau * tau) with (way vel x t ^ 2) by (field; lra). nra.
Qed.

(** ** What an interval draws: [x] the way before the output changes, [y] that after *)

Let p := latency_memory kappa f.
Let held (w : nat -> R) : R :=
  H * extra k (2 * p) w + sum_to n (fun j => a j * tail_squares k f j w).

Lemma interval_form : forall h x y, 0 <= x -> 0 <= y ->
  H * (x ^ 2 / 2 + far h (S k) * x + y ^ 2 / 2 + (x + far h k) * y)
  + tails h (S k) * x + tails h k * y + (held (push (x + y) (s h)) - held (s h))
  <= (H * kappa + sum_to n a) * (x ^ 2 / f + y ^ 2 / (1 - f)).
Proof.
  intros h x y Hx Hy.
  assert (K0 : 0 < kappa) by (unfold spare_mean in enough_mean; pose proof (pos_INR k); lra).
  pose proof (latency_first_part kappa f (s h (S k)) x f_between K0) as L1.
  pose proof (latency_second_part kappa f (INR k) x y f_between (pos_INR k) enough_mean
    enough_square) as L2. fold p in L1, L2.
  pose proof (delay_storage_push k (x + y) (s h)) as D1.
  pose proof (damping_storage_push k (2 * p) (x + y) (s h)) as D2.
  pose proof (path_by_squares k (x + y) (s h)) as Ps.
  rewrite (Rabs_right (x + y)) in Ps by lra.
  rewrite (sum_to_ext k (fun j => Rabs (s h j)) (s h)) in Ps
    by (intros; apply Rabs_right, Rle_ge, heard_pos).
  fold (far h k) in Ps. set (sq := sum_to k (fun j => s h j ^ 2)) in *.
  assert (Main : x ^ 2 / 2 + far h (S k) * x + y ^ 2 / 2 + (x + far h k) * y
    + (extra k (2 * p) (push (x + y) (s h)) - extra k (2 * p) (s h))
    <= kappa * (x ^ 2 / f + y ^ 2 / (1 - f))).
  { unfold extra. unfold far at 1. rewrite sum_to_S. fold (far h k). lra. }
  apply (Rmult_le_compat_l H) in Main; [| exact sum_nonneg].
  set (E := x ^ 2 / f + y ^ 2 / (1 - f)) in *.
  assert (Sq : (x + y) ^ 2 <= E).
  { unfold E. assert (Z : x ^ 2 / f + y ^ 2 / (1 - f) - (x + y) ^ 2
      = ((1 - f) * x - f * y) ^ 2 / (f * (1 - f))) by (field; lra).
    assert (0 <= ((1 - f) * x - f * y) ^ 2 / (f * (1 - f)))
      by (apply Rdiv_le_0_compat; [apply pow2_ge_0 | nra]). lra. }
  assert (Tails : tails h (S k) * x + tails h k * y
    + (sum_to n (fun j => a j * tail_squares k f j (push (x + y) (s h)))
       - sum_to n (fun j => a j * tail_squares k f j (s h))) <= sum_to n a * E).
  { unfold tails.
    assert (D : forall F G : nat -> R, sum_to n F - sum_to n G = sum_to n (fun j => F j + - 1 * G j)).
    { intros F G. rewrite sum_to_plus, sum_to_scal. ring. }
    rewrite D, !(Rmult_comm (sum_to n _)), <- !sum_to_scal, <- !sum_to_plus.
    apply sum_to_le. intros j Hj.
    pose proof (tail_squares_push k f j (x + y) (s h) (proj1 Hj)) as T.
    simpl (S k + j)%nat. set (w1 := s h (S (k + j))) in *. set (w0 := s h (k + j)%nat) in *.
    assert (One : w1 * x + w0 * y + (tail_squares k f j (push (x + y) (s h)) - tail_squares k f j (s h))
                  <= E).
    { rewrite T.
      assert (A1 : w1 * x <= (f * w1 ^ 2 + x ^ 2 / f) / 2).
      { assert (Z : f * w1 ^ 2 + x ^ 2 / f - 2 * (w1 * x) = (f * w1 - x) ^ 2 / f) by (field; lra).
        assert (0 <= (f * w1 - x) ^ 2 / f) by (apply Rdiv_le_0_compat; [apply pow2_ge_0 | lra]). lra. }
      assert (A2 : w0 * y <= ((1 - f) * w0 ^ 2 + y ^ 2 / (1 - f)) / 2).
      { assert (Z : (1 - f) * w0 ^ 2 + y ^ 2 / (1 - f) - 2 * (w0 * y)
          = ((1 - f) * w0 - y) ^ 2 / (1 - f)) by (field; lra).
        assert (0 <= ((1 - f) * w0 - y) ^ 2 / (1 - f))
          by (apply Rdiv_le_0_compat; [apply pow2_ge_0 | lra]). lra. }
      unfold E in *. lra. }
    apply (Rmult_le_compat_l (a j)) in One; [| apply Rabs_pos]. lra. }
  unfold held. lra.
Qed.

(** ** The run *)

Let W (h : nat) : R := held (s h).
Let X (h : nat) (t : R) : R := held (push (way vel (INR h) t) (s h)).
Let work (t : R) : R := RInt (fun v => force v * vel v) 0 t.

Lemma held_ext : forall w w', (forall j, (1 <= j)%nat -> w j = w' j) -> held w = held w'.
Proof.
  intros w w' E. unfold held, tail_squares. rewrite (extra_ext k (2 * p) w w' E). f_equal.
  apply sum_to_ext. intros j Hj. rewrite (E (S (k + j))) by lia. do 3 f_equal.
  apply sum_to_ext. intros i Hi. rewrite E by lia. reflexivity.
Qed.

Lemma held_at_least : forall w, 0 <= held w.
Proof.
  intro w. unfold held.
  assert (P0 : 0 <= 2 * p).
  { unfold p, latency_memory. unfold spare_mean in enough_mean. pose proof (pos_INR k).
    assert (0 <= f * (1 - f) / (4 * kappa)) by (apply Rdiv_le_0_compat; nra). lra. }
  assert (0 <= H * extra k (2 * p) w)
    by (apply Rmult_le_pos; [exact sum_nonneg | apply extra_nonneg, P0]).
  assert (0 <= sum_to n (fun j => a j * tail_squares k f j w)).
  { apply sum_to_nonneg. intros j _. apply Rmult_le_pos; [apply Rabs_pos |].
    apply tail_squares_nonneg. lra. }
  lra.
Qed.

Lemma latency_arrives : forall h, X h (INR (S h)) = W (S h).
Proof.
  intro h. apply held_ext. intros [| [| j]] Hj; [lia | |].
  - unfold s, heard_way. simpl. rewrite Nat.sub_0_r. reflexivity.
  - reflexivity.
Qed.

(** The interval up to [t]: the work exists, and is at most the form's first part. *)
Lemma interval_work : forall h t, INR h <= t <= INR (S h) -> exists x y w,
  0 <= x /\ 0 <= y /\ x + y = way vel (INR h) t /\
  x ^ 2 / f + y ^ 2 / (1 - f) <= square_integral vel (INR h) t /\
  is_RInt (fun v => force v * vel v) (INR h) t w /\
  w + (V (pos t) - V (pos (INR h)))
  <= H * (x ^ 2 / 2 + far h (S k) * x + y ^ 2 / 2 + (x + far h k) * y)
     + tails h (S k) * x + tails h k * y + coulomb * (x + y).
Proof.
  intros h t Ht. rewrite S_INR in Ht. set (c1 := INR h + f).
  assert (First : forall z, INR h <= z <= c1 ->
    is_RInt (fun v => force v * vel v) (INR h) z (u (h - S k)%nat * (pos z - pos (INR h))) /\
    u (h - S k)%nat * (pos z - pos (INR h)) + (V (pos z) - V (pos (INR h)))
    <= H * (way vel (INR h) z ^ 2 / 2)
       + (H * far h (S k) + tails h (S k) + coulomb) * way vel (INR h) z).
  { intros z Hz. apply held_work; [lra | |].
    - intros v Hv. apply (proj1 (acts h v)). unfold c1 in Hz. lra.
    - intros v Hv. pose proof (late_command h (S k) v ltac:(lra)). lra. }
  destruct (Rle_lt_dec t c1) as [L | L].
  - destruct (First t ltac:(lra)) as [I B].
    exists (way vel (INR h) t), 0, (u (h - S k)%nat * (pos t - pos (INR h))).
    split; [apply way_pos; lra |]. split; [lra |]. split; [ring |]. split; [| split].
    + pose proof (way_at_most (INR h) t f ltac:(lra) ltac:(unfold c1 in L; lra) ltac:(lra)).
      replace (0 ^ 2 / (1 - f)) with 0 by (field; lra). lra.
    + exact I.
    + lra.
  - destruct (First c1 ltac:(unfold c1; lra)) as [I B].
    set (x := way vel (INR h) c1) in *. set (y := way vel c1 t).
    assert (Second : is_RInt (fun v => force v * vel v) c1 t (u (h - k)%nat * (pos t - pos c1)) /\
      u (h - k)%nat * (pos t - pos c1) + (V (pos t) - V (pos c1))
      <= H * (way vel c1 t ^ 2 / 2) + (H * (x + far h k) + tails h k + coulomb) * way vel c1 t).
    { apply held_work; [lra | |].
      - intros v Hv. apply (proj2 (acts h v)). rewrite S_INR. unfold c1 in Hv. lra.
      - intros v Hv. pose proof (late_command h k v ltac:(unfold c1 in Hv; lra)) as C.
        rewrite (way_split (INR h) c1 v) in C. fold x in C. lra. }
    destruct Second as [J B2]. fold y in B2.
    exists x, y, (u (h - S k)%nat * (pos c1 - pos (INR h)) + u (h - k)%nat * (pos t - pos c1)).
    split; [apply way_pos; unfold c1; lra |]. split; [apply way_pos; lra |].
    split; [symmetry; apply way_split |]. split; [| split].
    + pose proof (way_at_most (INR h) c1 f ltac:(unfold c1; lra) ltac:(unfold c1; lra) ltac:(lra)).
      pose proof (way_at_most c1 t (1 - f) ltac:(lra) ltac:(unfold c1; lra) ltac:(lra)).
      unfold square_integral in *.
      rewrite (RInt_split _ (INR h) c1 t) by apply (square_integrable pos vel K).
      unfold x, y. lra.
    + apply is_RInt_join with c1; assumption.
    + lra.
Qed.

Lemma latency_work_to : forall h t, INR h <= t <= INR (S h) ->
  ex_RInt (fun v => force v * vel v) 0 t.
Proof.
  induction h as [| h IH]; intros t Ht;
    destruct (interval_work _ t Ht) as (x & y & w & _ & _ & _ & _ & I & _).
  - eexists. exact I.
  - apply (@ex_RInt_Chasles R_NormedModule) with (INR (S h)); [| eexists; exact I].
    apply IH. rewrite S_INR. lra.
Qed.

Lemma latency_charge : forall h t, INR h <= t <= INR (S h) ->
  (forall v, INR h <= v <= t -> vel v <> 0 ->
     0 <= margin_8 (beta - (H * kappa + sum_to n a)) (sigma - coulomb) (vel v)) ->
  generated 0 (pos (INR h)) (pos t) (V (pos (INR h))) (V (pos t))
  + (X h t + work t) - (W h + work (INR h)) <= dissipated beta sigma vel (INR h) t.
Proof.
  intros h t Ht H8.
  pose proof (instant_friction beta sigma (H * kappa + sum_to n a) coulomb pos vel K (INR h) t
    (proj1 Ht) H8) as F.
  fold (way vel (INR h) t) in F.
  destruct (interval_work h t Ht) as (x & y & w & Hx & Hy & Exy & Sq & I & B).
  pose proof (interval_form h x y Hx Hy) as Q.
  assert (S1 : work t - work (INR h) = w).
  { unfold work. rewrite (RInt_split _ 0 (INR h) t).
    - rewrite (is_RInt_unique _ _ _ _ I). ring.
    - apply (latency_work_to h). lra.
    - eexists. exact I. }
  assert (N0 : 0 <= H * kappa + sum_to n a).
  { assert (0 <= sum_to n a) by (apply sum_to_nonneg; intros; apply Rabs_pos).
    unfold spare_mean in enough_mean. pose proof (pos_INR k).
    assert (0 <= H * kappa) by (apply Rmult_le_pos; [exact sum_nonneg | lra]). lra. }
  apply (Rmult_le_compat_l _ _ _ N0) in Sq.
  unfold generated, X, W. rewrite <- Exy in *. lra.
Qed.

(** TH-LATENCY (any controller): the criterion is (beta - H(1) kappa - |g_1| - ... - |g_n|)|v| +
    (sigma - e|c|_1 - delta/2) >= 0, for the wall and for the one that is one-sided or saturated;
    after rest. *)
Theorem TH_LATENCY_controller : forall t, 0 <= t ->
  criterion_holds (beta - (H * kappa + tails_norm (tail c n) n)) (sigma - coulomb) vel t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0)) (kinetic mu (vel t) + V (pos t)) t.
Proof.
  intros t Ht H8. destruct (INR_covers t Ht) as (N & HN).
  destruct (EQ_14_run mu beta sigma INR (fun _ => 0) pos vel friction (fun v => hand v + force v)
    P O V (fun h => W h + work (INR h)) (fun h t => X h t + work t) INR_increasing)
    with (N := N) (t := t) as (I & E).
  - intro h. rewrite latency_arrives. reflexivity.
  - exact HN.
  - intros h v Hr.
    destruct (reached_range _ INR_increasing N t HN h v Hr) as (R0 & R1 & R2).
    assert (R3 : INR h <= v).
    { destruct Hr as [[_ ->] | [-> ->]]; [rewrite S_INR; lra | lra]. }
    apply latency_charge; [lra |]. intros z Hz. apply H8. simpl (INR 0) in R0. lra.
  - simpl (INR 0) in *.
    assert (Iw : ex_RInt (fun v => force v * vel v) 0 t) by (apply (latency_work_to N); exact HN).
    assert (Ih : is_RInt (fun v => hand v * vel v) 0 t
      (operator_energy vel (fun v => hand v + force v) 0 t - work t)).
    { apply is_RInt_ext with (fun v => (hand v + force v) * vel v - force v * vel v);
        [over_R; ring |].
      apply (@is_RInt_minus R_NormedModule (fun v => (hand v + force v) * vel v));
        apply RInt_is; assumption. }
    split; [eexists; exact Ih |].
    unfold operator_energy at 1. rewrite (is_RInt_unique _ _ _ _ Ih).
    assert (W0 : work 0 = 0) by (unfold work; rewrite RInt_point; reflexivity).
    assert (H0 : W 0 = 0).
    { unfold W, held. rewrite (extra_ext k (2 * p) (s 0%nat) (fun _ => 0)).
      - rewrite sum_to_zero.
        + unfold extra, delay_storage, damping_storage.
          rewrite !sum_to_zero by (intros; unfold Rdiv; ring). field.
        + intros j Hj. unfold tail_squares. rewrite sum_to_zero.
          * unfold s, heard_way. simpl. field.
          * intros i Hi. unfold s, heard_way. destruct i as [| i]; [lia |]. simpl. ring.
      - intros [| j] Hj; [lia | reflexivity]. }
    pose proof (held_at_least (push (way vel (INR N) t) (s N))) as X0. fold (X N t) in X0.
    rewrite W0, H0 in E. lra.
Qed.

End LatencyController.
