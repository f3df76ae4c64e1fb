(** * TH-NDOF: a device of n joints against one wall, for any n.

    Interval by interval, with units: the wall's torques are -K·(measured q), held. What moves the
    joints, and what their inertia does, is no part of it. What friction takes at least in an interval,
    [friction_at_least], is EQ-26 joint by joint. *)

From Coq Require Import Reals Lra Lia Psatz.
From Passivity Require Import Definitions Quantizer.
Open Scope R_scope.

(** f 0 + ... + f (n - 1). *)
Fixpoint total (n : nat) (f : nat -> R) : R :=
  match n with
  | O => 0
  | S n => total n f + f n
  end.

Lemma total_ext : forall n f g, (forall i, (i < n)%nat -> f i = g i) -> total n f = total n g.
Proof. induction n; intros f g H; simpl; [reflexivity |]. rewrite (IHn f g), H; auto. Qed.

Lemma total_le : forall n f g, (forall i, (i < n)%nat -> f i <= g i) -> total n f <= total n g.
Proof.
  induction n; intros f g H; simpl; [lra |].
  assert (total n f <= total n g) by (apply IHn; auto). specialize (H n (Nat.lt_succ_diag_r n)). lra.
Qed.

Lemma total_nonneg : forall n f, (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= total n f.
Proof.
  induction n; intros f H; simpl; [lra |].
  assert (0 <= total n f) by (apply IHn; auto). specialize (H n (Nat.lt_succ_diag_r n)). lra.
Qed.

Lemma total_plus : forall n f g, total n (fun i => f i + g i) = total n f + total n g.
Proof. induction n; intros; simpl; [lra |]. rewrite IHn. lra. Qed.

Lemma total_minus : forall n f g, total n (fun i => f i - g i) = total n f - total n g.
Proof. induction n; intros; simpl; [lra |]. rewrite IHn. lra. Qed.

Lemma total_times : forall n c f, total n (fun i => c * f i) = c * total n f.
Proof. induction n; intros; simpl; [lra |]. rewrite IHn. lra. Qed.

Lemma total_swap : forall n m (f : nat -> nat -> R),
  total n (fun i => total m (f i)) = total m (fun j => total n (fun i => f i j)).
Proof.
  induction n; intros m f; simpl.
  - induction m; simpl; [reflexivity |]. rewrite <- IHm. lra.
  - rewrite IHn, <- total_plus. reflexivity.
Qed.

Lemma total_abs : forall n f, Rabs (total n f) <= total n (fun i => Rabs (f i)).
Proof.
  induction n; intros f; simpl; [rewrite Rabs_R0; lra |].
  pose proof (Rabs_triang (total n f) (f n)). specialize (IHn f). lra.
Qed.

Section Device.

Variable n : nat.
Variable K : nat -> nat -> R.
Variables b c delta : nat -> R.
Variable T : R.
Hypothesis symmetric : forall i j, K i j = K j i.
Hypothesis period_positive : 0 < T.

(** xᵀKy. *)
Definition form (x y : nat -> R) : R := total n (fun i => x i * total n (fun j => K i j * y j)).

(** Work of the torques -K·m on the displacement d. *)
Definition wall_work (m d : nat -> R) : R := - form d m.

(** What the held torques generate from x0 to x1, against the spring -Kq. *)
Definition generated (m x0 x1 : nat -> R) : R :=
  wall_work m (fun i => x1 i - x0 i) + form x1 x1 / 2 - form x0 x0 / 2.

(** Half of Σ |K i j|·Δ j: the Coulomb friction that the encoders ask of joint i. *)
Definition coulomb_needed (i : nat) : R := total n (fun j => Rabs (K i j) * delta j) / 2.

(** Friction in an interval of length [time], at least. *)
Definition friction_at_least (time : R) (d : nat -> R) : R :=
  total n (fun i => b i * d i ^ 2 / time + c i * Rabs (d i)).

(** What is measured is off by half a tick at most; Δ = 0 stands for no encoder. *)
Definition measures (m x : nat -> R) : Prop :=
  forall j, (j < n)%nat -> Rabs (x j - m j) <= delta j / 2.

Lemma form_plus_left : forall x y z, form (fun i => x i + y i) z = form x z + form y z.
Proof.
  intros. unfold form. rewrite <- total_plus. apply total_ext. intros. ring.
Qed.

Lemma form_minus_left : forall x y z, form (fun i => x i - y i) z = form x z - form y z.
Proof.
  intros. unfold form. rewrite <- total_minus. apply total_ext. intros. ring.
Qed.

Lemma form_minus_right : forall x y z, form x (fun i => y i - z i) = form x y - form x z.
Proof.
  intros. unfold form. rewrite <- total_minus. apply total_ext. intros.
  rewrite <- Rmult_minus_distr_l, <- total_minus. f_equal. apply total_ext. intros. ring.
Qed.

Lemma form_comm : forall x y, form x y = form y x.
Proof.
  intros. unfold form.
  transitivity (total n (fun i => total n (fun j => x i * (K i j * y j)))).
  - apply total_ext. intros. rewrite total_times. reflexivity.
  - rewrite total_swap. apply total_ext. intros j Hj. rewrite <- total_times.
    apply total_ext. intros. rewrite (symmetric j i). ring.
Qed.

(** The generated energy by residues, ½dᵀKd + Σ dᵢKᵢⱼ(xⱼ − mⱼ). *)
Theorem TH_NDOF_generated : forall m x0 x1,
  generated m x0 x1 =
  form (fun i => x1 i - x0 i) (fun i => x1 i - x0 i) / 2 +
  form (fun i => x1 i - x0 i) (fun i => x0 i - m i).
Proof.
  intros. unfold generated, wall_work.
  rewrite !form_minus_right, !form_minus_left, (form_comm x0 x1). lra.
Qed.

Lemma error_bound : forall d m x, measures m x ->
  form d (fun i => x i - m i) <= total n (fun i => Rabs (d i) * coulomb_needed i).
Proof.
  intros d m x M. unfold form. apply total_le. intros i _.
  apply Rle_trans with (Rabs (d i * total n (fun j => K i j * (x j - m j)))); [apply Rle_abs |].
  rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos |].
  apply Rle_trans with (total n (fun j => Rabs (K i j * (x j - m j)))); [apply total_abs |].
  unfold coulomb_needed, Rdiv. rewrite Rmult_comm, <- total_times.
  apply total_le. intros j Hj. rewrite Rabs_mult.
  apply Rle_trans with (Rabs (K i j) * (delta j / 2)).
  - apply Rmult_le_compat_l; [apply Rabs_pos | apply M, Hj].
  - right. unfold Rdiv. ring.
Qed.

(** The bound ½dᵀKd + ½Σ|dᵢ|Σ|Kᵢⱼ|Δⱼ. *)
Theorem TH_NDOF_bound : forall m x0 x1, measures m x0 ->
  generated m x0 x1 <=
  form (fun i => x1 i - x0 i) (fun i => x1 i - x0 i) / 2 +
  total n (fun i => Rabs (x1 i - x0 i) * coulomb_needed i).
Proof.
  intros m x0 x1 M. rewrite TH_NDOF_generated.
  pose proof (error_bound (fun i => x1 i - x0 i) m x0 M). simpl in *. lra.
Qed.

(** diag(b) − (T/2)K is positive semidefinite. *)
Definition viscous_definite : Prop :=
  forall d, 0 <= total n (fun i => b i * d i ^ 2) - T / 2 * form d d.

Definition coulomb_enough : Prop := forall i, (i < n)%nat -> coulomb_needed i <= c i.

Definition friction_nonneg : Prop := forall i, (i < n)%nat -> 0 <= b i.

Lemma viscous_in_time : forall time d, friction_nonneg -> 0 < time <= T ->
  total n (fun i => b i * d i ^ 2) / T <= total n (fun i => b i * d i ^ 2 / time).
Proof.
  intros time d B [H0 HT]. unfold Rdiv at 1. rewrite Rmult_comm, <- total_times.
  apply total_le. intros i Hi. unfold Rdiv.
  rewrite (Rmult_comm (/ T)). apply Rmult_le_compat_l.
  - apply Rmult_le_pos; [apply B, Hi | apply pow2_ge_0].
  - apply Rinv_le_contravar; lra.
Qed.

Lemma friction_split : forall time d, friction_at_least time d =
  total n (fun i => b i * d i ^ 2 / time) + total n (fun i => c i * Rabs (d i)).
Proof. intros. unfold friction_at_least. apply total_plus. Qed.

(** In no interval is more generated than friction takes, at every speed. *)
Theorem TH_NDOF_interval : forall m x0 x1 time,
  friction_nonneg -> viscous_definite -> coulomb_enough ->
  measures m x0 -> 0 < time <= T ->
  generated m x0 x1 <= friction_at_least time (fun i => x1 i - x0 i).
Proof.
  intros m x0 x1 time B V C M Ht.
  apply Rle_trans with (1 := TH_NDOF_bound m x0 x1 M).
  set (d := fun i => x1 i - x0 i). rewrite friction_split.
  apply Rplus_le_compat.
  - apply Rle_trans with (2 := viscous_in_time time d B Ht).
    specialize (V d). apply Rmult_le_reg_l with (T); [exact period_positive |].
    replace (T * (total n (fun i => b i * d i ^ 2) / T)) with (total n (fun i => b i * d i ^ 2))
      by (field; lra).
    lra.
  - apply total_le. intros i Hi. rewrite Rmult_comm.
    apply Rmult_le_compat_r; [apply Rabs_pos | apply C, Hi].
Qed.

(** Up to bounds V on the speeds of the joints: with xᵢ = 0 and xᵢ = VᵢT, all other xⱼ = VⱼT,
    bᵢxᵢ/T + cᵢ ≥ ½Σ|Kᵢⱼ|(xⱼ + Δⱼ). *)
Definition others (V : nat -> R) (i : nat) : R :=
  total n (fun j => if Nat.eq_dec i j then 0 else Rabs (K i j) * (V j * T)).

Definition criterion_up_to (V : nat -> R) : Prop := forall i, (i < n)%nat ->
  0 <= c i - coulomb_needed i - others V i / 2 /\
  0 <= c i - coulomb_needed i - others V i / 2 + V i * (b i - Rabs (K i i) * T / 2).

Lemma row_split : forall (V : nat -> R) i (d : nat -> R), (i < n)%nat ->
  (forall j, (j < n)%nat -> Rabs (d j) <= V j * T) ->
  total n (fun j => Rabs (K i j) * Rabs (d j)) <= others V i + Rabs (K i i) * Rabs (d i).
Proof.
  intros V i d Hi Hd. unfold others.
  assert (G : forall m, (m <= n)%nat ->
    total m (fun j => Rabs (K i j) * Rabs (d j)) <=
    total m (fun j => if Nat.eq_dec i j then 0 else Rabs (K i j) * (V j * T)) +
    (if lt_dec i m then Rabs (K i i) * Rabs (d i) else 0)).
  { induction m; intros Hm; simpl; [destruct (lt_dec i 0); [lia | lra] |].
    assert (Hm' : (m <= n)%nat) by lia. specialize (IHm Hm').
    assert (D : Rabs (K i m) * Rabs (d m) <= Rabs (K i m) * (V m * T)).
    { apply Rmult_le_compat_l; [apply Rabs_pos | apply Hd; lia]. }
    destruct (Nat.eq_dec i m) as [E | E].
    - subst m. destruct (lt_dec i i); [lia |]. destruct (lt_dec i (S i)); [lra | lia].
    - destruct (lt_dec i m), (lt_dec i (S m)); try lia; lra. }
  specialize (G n (Nat.le_refl n)). destruct (lt_dec i n); [exact G | contradiction].
Qed.

Theorem TH_NDOF_interval_up_to : forall V m x0 x1 time,
  friction_nonneg -> criterion_up_to V -> measures m x0 -> 0 < time <= T ->
  (forall i, (i < n)%nat -> Rabs (x1 i - x0 i) <= V i * T) ->
  generated m x0 x1 <= friction_at_least time (fun i => x1 i - x0 i).
Proof.
  intros V m x0 x1 time B C M Ht Hd.
  apply Rle_trans with (1 := TH_NDOF_bound m x0 x1 M).
  set (d := fun i => x1 i - x0 i) in *.
  apply Rle_trans with (total n (fun i =>
    Rabs (d i) * (total n (fun j => Rabs (K i j) * Rabs (d j)) / 2 + coulomb_needed i))).
  - rewrite (total_ext n (fun i => Rabs (d i) * (_ + _)) (fun i =>
      Rabs (d i) * (total n (fun j => Rabs (K i j) * Rabs (d j)) / 2) + Rabs (d i) * coulomb_needed i))
      by (intros; ring).
    rewrite total_plus. apply Rplus_le_compat_r.
    unfold form, Rdiv. rewrite Rmult_comm, <- total_times. apply total_le. intros i _.
    rewrite <- Rmult_assoc, (Rmult_comm (/ 2)), Rmult_assoc, (Rmult_comm (/ 2)).
    apply Rle_trans with (Rabs (d i * (total n (fun j => K i j * d j) * / 2))); [apply Rle_abs |].
    rewrite !Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos |].
    rewrite (Rabs_right (/ 2)) by lra. apply Rmult_le_compat_r; [lra |].
    apply Rle_trans with (1 := total_abs n _). apply total_le. intros j _.
    rewrite Rabs_mult. lra.
  - rewrite friction_split.
    apply Rle_trans with
      (total n (fun i => b i * d i ^ 2 / T) + total n (fun i => c i * Rabs (d i))).
    + rewrite <- total_plus. apply total_le. intros i Hi.
      destruct (C i Hi) as [C0 C1]. specialize (Hd i Hi) as Di.
      pose proof (row_split V i d Hi Hd) as R.
      set (a := Rabs (d i)) in *. assert (A : 0 <= a) by apply Rabs_pos.
      assert (S : d i ^ 2 = a ^ 2) by (unfold a; rewrite <- Rsqr_pow2, <- Rsqr_pow2; apply Rsqr_abs).
      rewrite S. fold (d i) in *.
      assert (L : 0 <= c i - coulomb_needed i - others V i / 2 +
                  a / T * (b i - Rabs (K i i) * T / 2)).
      { set (p := c i - coulomb_needed i - others V i / 2) in *.
        set (s := b i - Rabs (K i i) * T / 2) in *.
        assert (P0 : 0 <= a / T) by (apply Rmult_le_pos; [exact A | left; apply Rinv_0_lt_compat; lra]).
        assert (P1 : a / T <= V i).
        { apply Rmult_le_reg_r with T; [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
          rewrite Rmult_1_r. exact Di. }
        destruct (Rle_dec 0 s) as [Hs | Hs].
        - assert (0 <= a / T * s) by (apply Rmult_le_pos; assumption). lra.
        - assert (V i * s <= a / T * s) by nra. lra. }
      assert (E : a * (c i - coulomb_needed i - others V i / 2 + a / T * (b i - Rabs (K i i) * T / 2)) =
                  (b i * a ^ 2 / T + c i * a) -
                  a * ((others V i + Rabs (K i i) * a) / 2 + coulomb_needed i)) by (field; lra).
      assert (0 <= a * (c i - coulomb_needed i - others V i / 2 + a / T * (b i - Rabs (K i i) * T / 2)))
        by (apply Rmult_le_pos; assumption).
      assert (a * (total n (fun j => Rabs (K i j) * Rabs (d j)) / 2 + coulomb_needed i) <=
              a * ((others V i + Rabs (K i i) * a) / 2 + coulomb_needed i))
        by (apply Rmult_le_compat_l; lra).
      lra.
    + apply Rplus_le_compat_r.
      pose proof (viscous_in_time time d B Ht) as W.
      replace (total n (fun i => b i * d i ^ 2 / T)) with (total n (fun i => b i * d i ^ 2) / T).
      * exact W.
      * unfold Rdiv at 1. rewrite Rmult_comm, <- total_times. apply total_ext. intros. unfold Rdiv. ring.
Qed.

(** K is positive semidefinite: the wall is a spring. *)
Definition is_spring : Prop := forall x, 0 <= form x x.

(** Over any number of intervals, each of at most a period and with friction as EQ-26 has it, the
    operator draws no more than the wall stored at the start. *)
Theorem TH_NDOF_run : forall (x m : nat -> nat -> R) (time friction : nat -> R),
  friction_nonneg -> viscous_definite -> coulomb_enough -> is_spring ->
  (forall h, measures (m h) (x h)) -> (forall h, 0 < time h <= T) ->
  (forall h, friction_at_least (time h) (fun i => x (S h) i - x h i) <= friction h) ->
  forall N, total N (fun h => wall_work (m h) (fun i => x (S h) i - x h i) - friction h) <=
            form (x O) (x O) / 2.
Proof.
  intros x m time friction B V C P M Ht F N.
  assert (G : total N (fun h => wall_work (m h) (fun i => x (S h) i - x h i) - friction h) <=
              form (x O) (x O) / 2 - form (x N) (x N) / 2).
  { induction N; simpl; [lra |].
    pose proof (TH_NDOF_interval (m N) (x N) (x (S N)) (time N) B V C (M N) (Ht N)) as I.
    specialize (F N). unfold generated in I. simpl in *. lra. }
  specialize (P (x N)). lra.
Qed.

(** The same up to bounds on the speeds of the joints. *)
Theorem TH_NDOF_run_up_to : forall V (x m : nat -> nat -> R) (time friction : nat -> R),
  friction_nonneg -> criterion_up_to V -> is_spring ->
  (forall h, measures (m h) (x h)) -> (forall h, 0 < time h <= T) ->
  (forall h i, (i < n)%nat -> Rabs (x (S h) i - x h i) <= V i * T) ->
  (forall h, friction_at_least (time h) (fun i => x (S h) i - x h i) <= friction h) ->
  forall N, total N (fun h => wall_work (m h) (fun i => x (S h) i - x h i) - friction h) <=
            form (x O) (x O) / 2.
Proof.
  intros V x m time friction B C P M Ht D F N.
  assert (G : total N (fun h => wall_work (m h) (fun i => x (S h) i - x h i) - friction h) <=
              form (x O) (x O) / 2 - form (x N) (x N) / 2).
  { induction N; simpl; [lra |].
    pose proof (TH_NDOF_interval_up_to V (m N) (x N) (x (S N)) (time N) B C (M N) (Ht N) (D N)) as I.
    specialize (F N). unfold generated in I. simpl in *. lra. }
  specialize (P (x N)). lra.
Qed.

End Device.

(** ** A wall with a direction, K = k·aaᵀ *)

Definition along (k : R) (a : nat -> R) (i j : nat) : R := k * a i * a j.

Lemma along_form : forall n k a x y,
  form n (along k a) x y = k * total n (fun i => a i * x i) * total n (fun i => a i * y i).
Proof.
  intros. unfold form, along.
  rewrite (total_ext n _ (fun i => (k * total n (fun j => a j * y j)) * (a i * x i))).
  - rewrite total_times. ring.
  - intros i _.
    rewrite (total_ext n (fun j => k * a i * a j * y j) (fun j => (k * a i) * (a j * y j)))
      by (intros; ring).
    rewrite total_times. ring.
Qed.

(** Cauchy and Schwarz with weights b. *)
Lemma weighted_square : forall n (a b d : nat -> R), (forall i, (i < n)%nat -> 0 < b i) ->
  total n (fun i => a i * d i) ^ 2 <=
  total n (fun i => a i ^ 2 / b i) * total n (fun i => b i * d i ^ 2).
Proof.
  induction n; intros a b d B; cbn [total]; [lra |].
  assert (B' : forall i, (i < n)%nat -> 0 < b i) by auto.
  specialize (IHn a b d B').
  set (p := total n (fun i => a i * d i)) in *.
  set (q := total n (fun i => a i ^ 2 / b i)) in *.
  set (r := total n (fun i => b i * d i ^ 2)) in *.
  assert (Q : 0 <= q).
  { apply total_nonneg. intros i Hi. apply Rmult_le_pos; [apply pow2_ge_0 |].
    left. apply Rinv_0_lt_compat, B', Hi. }
  assert (R0 : 0 <= r).
  { apply total_nonneg. intros i Hi. apply Rmult_le_pos; [left; apply B', Hi | apply pow2_ge_0]. }
  specialize (B n (Nat.lt_succ_diag_r n)).
  set (u := a n) in *. set (v := d n) in *. set (w := b n) in *.
  assert (H : 2 * p * (u * v) <= q * (w * v ^ 2) + u ^ 2 / w * r).
  { (* (2pX)² ≤ 4qrX² ≤ (q·A + C·r)² with A·C = X² *)
    set (A := w * v ^ 2). set (C := u ^ 2 / w).
    assert (HA : 0 <= A) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
    assert (HC : 0 <= C).
    { apply Rmult_le_pos; [apply pow2_ge_0 | left; apply Rinv_0_lt_compat, B]. }
    assert (AC : A * C = (u * v) ^ 2) by (unfold A, C; field; lra).
    assert (HS : 0 <= q * A + C * r).
    { assert (0 <= q * A) by (apply Rmult_le_pos; assumption).
      assert (0 <= C * r) by (apply Rmult_le_pos; assumption). lra. }
    assert (HQ : (2 * p * (u * v)) ^ 2 <= (q * A + C * r) ^ 2).
    { apply Rle_trans with (4 * (q * r) * (A * C)).
      - rewrite AC. replace ((2 * p * (u * v)) ^ 2) with (4 * p ^ 2 * (u * v) ^ 2) by ring.
        apply Rmult_le_compat_r; [apply pow2_ge_0 | lra].
      - assert (0 <= (q * A - C * r) ^ 2) by apply pow2_ge_0. nra. }
    apply Rnot_lt_le. intro N.
    assert (0 < 2 * p * (u * v) + (q * A + C * r)) by lra.
    assert (0 < (2 * p * (u * v) - (q * A + C * r)) * (2 * p * (u * v) + (q * A + C * r)))
      by (apply Rmult_lt_0_compat; lra).
    unfold A, C in *. lra. }
  assert (E : u ^ 2 / w * (w * v ^ 2) = (u * v) ^ 2) by (field; lra).
  apply Rle_trans with (p ^ 2 + 2 * p * (u * v) + u ^ 2 / w * (w * v ^ 2));
    [right; rewrite E; ring |].
  apply Rle_trans with (q * r + (q * (w * v ^ 2) + u ^ 2 / w * r) + u ^ 2 / w * (w * v ^ 2));
    [lra | right; unfold Rdiv; ring].
Qed.

(** k·T·Σ aᵢ²/bᵢ ≤ 2 makes diag(b) − (T/2)K positive semidefinite, and only that does. *)
Theorem TH_NDOF_direction : forall n k T (a b : nat -> R),
  0 <= k -> 0 < T -> (forall i, (i < n)%nat -> 0 < b i) ->
  (k * T * total n (fun i => a i ^ 2 / b i) <= 2 <-> viscous_definite n (along k a) b T).
Proof.
  intros n k T a b Hk HT B. unfold viscous_definite.
  set (q := total n (fun i => a i ^ 2 / b i)).
  assert (Q : 0 <= q).
  { apply total_nonneg. intros i Hi. apply Rmult_le_pos; [apply pow2_ge_0 |].
    left. apply Rinv_0_lt_compat, B, Hi. }
  split.
  - intros H d. rewrite along_form.
    pose proof (weighted_square n a b d B) as W. fold q in W.
    set (p := total n (fun i => a i * d i)) in *. set (r := total n (fun i => b i * d i ^ 2)) in *.
    assert (R0 : 0 <= r).
    { apply total_nonneg. intros i Hi. apply Rmult_le_pos; [left; apply B, Hi | apply pow2_ge_0]. }
    assert (KT : 0 <= k * T) by (apply Rmult_le_pos; lra).
    assert (k * T * p ^ 2 <= k * T * (q * r)) by (apply Rmult_le_compat_l; assumption).
    assert (k * T * q * r <= 2 * r) by (apply Rmult_le_compat_r; assumption).
    replace (T / 2 * (k * p * p)) with (k * T * p ^ 2 / 2) by field. lra.
  - intros H. specialize (H (fun i => a i / b i)). rewrite along_form in H.
    rewrite (total_ext n (fun i => b i * (a i / b i) ^ 2) (fun i => a i ^ 2 / b i)) in H.
    + rewrite (total_ext n (fun i => a i * (a i / b i)) (fun i => a i ^ 2 / b i)) in H.
      * fold q in H. destruct (Req_dec q 0) as [E | E]; [rewrite E; lra |].
        assert (0 < q) by lra.
        apply Rmult_le_reg_r with q; [assumption |]. lra.
      * intros i Hi. specialize (B i Hi). field. lra.
    + intros i Hi. specialize (B i Hi). field. lra.
Qed.

(** ** The converse, for ways of whole ticks and for one tick of every joint *)

(** A cycle x → x + d → x, each way in one period: m and m' are what is measured at its ends. *)
Definition cycle_gain (n : nat) (K : nat -> nat -> R) (b c : nat -> R) (T : R) (m m' d : nat -> R) : R :=
  wall_work n K m d + wall_work n K m' (fun i => - d i) - 2 * friction_at_least n b c T d.

(** Its gain is dᵀK(m' − m) less friction both ways. *)
Theorem TH_NDOF_cycle : forall n K b c T m m' d,
  cycle_gain n K b c T m m' d =
  form n K d (fun i => m' i - m i) - 2 * friction_at_least n b c T d.
Proof.
  intros. unfold cycle_gain, wall_work.
  rewrite form_minus_right.
  replace (form n K (fun i => - d i) m') with (- form n K d m').
  - lra.
  - unfold form. rewrite <- (Rmult_1_l (total n _)), <- Ropp_mult_distr_l_reverse, <- total_times.
    apply total_ext. intros. ring.
Qed.

(** A direction in which diag(b) − (T/2)K is negative draws, s times as long: what is measured changes by
    the way itself, as on ways of whole ticks. *)
Theorem TH_NDOF_active_viscous : forall n K b c T d,
  0 < T -> total n (fun i => b i * d i ^ 2) - T / 2 * form n K d d < 0 ->
  exists s0, forall s, s0 < s -> forall m m',
    (forall i, (i < n)%nat -> m' i - m i = s * d i) ->
    0 < cycle_gain n K b c T m m' (fun i => s * d i).
Proof.
  intros n K b c T d HT H.
  set (u := total n (fun i => c i * Rabs (d i))).
  set (r := total n (fun i => b i * d i ^ 2)) in *. set (f := form n K d d) in *.
  set (g := f - 2 * r / T).
  assert (G : 0 < g).
  { unfold g. apply Rmult_lt_reg_l with T; [exact HT |].
    replace (T * (f - 2 * r / T)) with (T * f - 2 * r) by (field; lra). lra. }
  exists (Rmax 0 (2 * u / g)). intros s Hs m m' M.
  assert (S0 : 0 < s) by (pose proof (Rmax_l 0 (2 * u / g)); lra).
  assert (S1 : 2 * u < s * g).
  { pose proof (Rmax_r 0 (2 * u / g)). apply Rmult_lt_reg_r with (/ g); [apply Rinv_0_lt_compat, G |].
    replace (s * g * / g) with s by (field; lra). unfold Rdiv in *. lra. }
  rewrite TH_NDOF_cycle.
  replace (form n K (fun i => s * d i) (fun i => m' i - m i)) with (s * s * f).
  - replace (friction_at_least n b c T (fun i => s * d i)) with (s * s * r / T + s * u).
    + replace (s * s * f - 2 * (s * s * r / T + s * u)) with (s * (s * g - 2 * u))
        by (unfold g; field; lra).
      apply Rmult_lt_0_compat; lra.
    + unfold friction_at_least, r, u. rewrite total_plus.
      unfold Rdiv at 1. f_equal.
      * rewrite (Rmult_comm _ (/ T)), <- Rmult_assoc, <- total_times. apply total_ext. intros.
        unfold Rdiv. ring.
      * rewrite <- total_times. apply total_ext. intros i Hi. rewrite Rabs_mult, (Rabs_right s) by lra.
        ring.
  - unfold f, form. rewrite <- total_times. apply total_ext. intros i Hi.
    rewrite <- (Rmult_assoc _ (d i)). rewrite (Rmult_assoc s s). rewrite (Rmult_comm s (s * d i)).
    rewrite Rmult_assoc. f_equal. rewrite <- total_times. apply total_ext. intros j Hj.
    rewrite M by exact Hj. ring.
Qed.

Definition side (x : R) : R := if Rlt_dec x 0 then -1 else 1.

Lemma side_times : forall x, x * side x = Rabs x.
Proof.
  intro x. unfold side. destruct (Rlt_dec x 0).
  - rewrite Rabs_left by assumption. ring.
  - rewrite Rabs_right by lra. ring.
Qed.

Lemma side_abs : forall x, Rabs (side x) = 1.
Proof.
  intro x. unfold side. destruct (Rlt_dec x 0).
  - rewrite Rabs_left; lra.
  - apply Rabs_R1.
Qed.

Lemma total_split : forall n i f, (i < n)%nat ->
  total n f = f i + total n (fun l => if Nat.eq_dec i l then 0 else f l).
Proof.
  intros n i f Hi.
  assert (G : forall m, total m f =
    (if lt_dec i m then f i else 0) + total m (fun l => if Nat.eq_dec i l then 0 else f l)).
  { induction m; simpl; [destruct (lt_dec i 0); [lia | lra] |]. rewrite IHm.
    destruct (Nat.eq_dec i m) as [E | E], (lt_dec i m), (lt_dec i (S m)); try lia; subst; lra. }
  rewrite (G n). destruct (lt_dec i n); [reflexivity | contradiction].
Qed.

(** Joint i a way [far], every other joint a way [near] to the side that its coupling to i helps. *)
Definition edge_way (K : nat -> nat -> R) (i : nat) (far near : R) (l : nat) : R :=
  if Nat.eq_dec i l then far else near * side (K i l).

(** An encoder of step Δ measures Δ·(⌊x/Δ⌋ + ½): within half a step, as the theorems ask. *)
Theorem TH_NDOF_encoder : forall delta x, 0 < delta ->
  Rabs (x - delta * measured (x / delta)) <= delta / 2.
Proof.
  intros delta x H. pose proof (measured_error (x / delta)) as [A B].
  assert (E : x - delta * measured (x / delta) = delta * - (measured (x / delta) - x / delta))
    by (field; lra).
  rewrite E, Rabs_mult, (Rabs_right delta), Rabs_Ropp by lra.
  replace (delta / 2) with (delta * (1 / 2)) by field.
  apply Rmult_le_compat_l; [lra |]. apply Rabs_le. lra.
Qed.

(** From just below an edge onto it, however near, what is measured changes by a whole step. *)
Theorem TH_NDOF_edge : forall delta near, 0 < delta -> 0 < near <= delta ->
  delta * measured (delta / delta) - delta * measured ((delta - near) / delta) = delta.
Proof.
  intros delta near H [N0 N1]. unfold measured.
  replace (delta / delta) with (IZR 1) by (field; lra).
  rewrite floor_IZR.
  rewrite (floor_unique ((delta - near) / delta) 0).
  - simpl. lra.
  - split.
    + apply Rmult_le_reg_r with delta; [exact H |]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l by lra. lra.
    + apply Rmult_lt_reg_r with delta; [exact H |]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

(** A joint with less Coulomb friction than the encoders ask of it draws: it moves some way up to any
    length and every other joint as little as one likes, each over one edge of its encoder ([TH_NDOF_edge];
    as K i i is not negative, joint i moves up over its own). *)
Theorem TH_NDOF_active_coulomb : forall n K b c delta T i,
  (i < n)%nat -> 0 < T -> 0 <= b i -> 0 <= K i i -> c i < coulomb_needed n K delta i ->
  forall longest, 0 < longest ->
  exists far, 0 < far <= longest /\ exists least, 0 < least /\
  forall near, 0 < near < least -> forall m m',
    (forall j, (j < n)%nat -> m' j - m j = side (K i j) * delta j) ->
    0 < cycle_gain n K b c T m m' (edge_way K i far near).
Proof.
  intros n K b c delta T i Hi HT Hb Hk Hc longest HL.
  set (short := coulomb_needed n K delta i - c i). assert (S0 : 0 < short) by (unfold short; lra).
  set (far := Rmin longest (short * T / (2 * (b i + 1)))).
  assert (F1 : 0 < short * T / (2 * (b i + 1))).
  { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; assumption |]. apply Rinv_0_lt_compat. lra. }
  assert (F0 : 0 < far) by (unfold far; apply Rmin_glb_lt; assumption).
  assert (FL : far <= longest) by apply Rmin_l.
  assert (FB : b i * far / T <= short / 2).
  { assert (far <= short * T / (2 * (b i + 1))) by apply Rmin_r.
    apply Rle_trans with (b i * (short * T / (2 * (b i + 1))) / T).
    - apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, HT |].
      apply Rmult_le_compat_l; assumption.
    - replace (b i * (short * T / (2 * (b i + 1))) / T) with (short / 2 * (b i / (b i + 1)))
        by (field; lra).
      assert (b i / (b i + 1) <= 1).
      { apply Rmult_le_reg_r with (b i + 1); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
      nra. }
  set (lone := fun f : nat -> R => total n (fun l => if Nat.eq_dec i l then 0 else f l)).
  set (G := lone (fun l => side (K i l) * total n (fun j => K l j * (side (K i j) * delta j)))).
  set (W := Rabs G + 2 * Rabs (lone (fun l => b l / T)) + 2 * Rabs (lone c)).
  assert (W0 : 0 <= W).
  { unfold W. pose proof (Rabs_pos G). pose proof (Rabs_pos (lone (fun l => b l / T))).
    pose proof (Rabs_pos (lone c)). lra. }
  exists far. split; [split; assumption |].
  exists (Rmin 1 (far * short / (W + 1))). split.
  { apply Rmin_glb_lt; [lra |]. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; assumption |].
    apply Rinv_0_lt_compat. lra. }
  intros near [N0 N1] m m' M.
  assert (N2 : near < 1) by (pose proof (Rmin_l 1 (far * short / (W + 1))); lra).
  assert (N3 : near * (W + 1) < far * short).
  { pose proof (Rmin_r 1 (far * short / (W + 1))). apply Rmult_lt_reg_r with (/ (W + 1)).
    - apply Rinv_0_lt_compat. lra.
    - rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra. unfold Rdiv in *. lra. }
  rewrite TH_NDOF_cycle.
  assert (E : form n K (edge_way K i far near) (fun j => m' j - m j) =
              far * (2 * coulomb_needed n K delta i) + near * G).
  { unfold form. rewrite (total_split n i _ Hi). unfold edge_way at 1.
    destruct (Nat.eq_dec i i) as [_ | Q]; [| contradiction]. f_equal.
    - f_equal. unfold coulomb_needed.
      replace (2 * (total n (fun j => Rabs (K i j) * delta j) / 2))
        with (total n (fun j => Rabs (K i j) * delta j)) by field.
      apply total_ext. intros j Hj. rewrite M by exact Hj. rewrite <- (side_times (K i j)). ring.
    - unfold G, lone. rewrite <- total_times. apply total_ext. intros l Hl. unfold edge_way.
      destruct (Nat.eq_dec i l); [ring |].
      rewrite (total_ext n (fun j => K l j * (m' j - m j))
                           (fun j => K l j * (side (K i j) * delta j))); [ring |].
      intros j Hj. rewrite M by exact Hj. reflexivity. }
  assert (D : friction_at_least n b c T (edge_way K i far near) =
              b i * far ^ 2 / T + c i * far +
              (near ^ 2 * lone (fun l => b l / T) + near * lone c)).
  { unfold friction_at_least. rewrite (total_split n i _ Hi). unfold edge_way at 1 2.
    destruct (Nat.eq_dec i i) as [_ | Q]; [| contradiction].
    rewrite (Rabs_right far) by lra. f_equal.
    unfold lone. rewrite <- !total_times, <- total_plus. apply total_ext. intros l Hl.
    unfold edge_way. destruct (Nat.eq_dec i l); [ring |].
    rewrite Rabs_mult, side_abs, (Rabs_right near) by lra.
    assert (Q : side (K i l) ^ 2 = 1) by (unfold side; destruct (Rlt_dec (K i l) 0); ring).
    replace ((near * side (K i l)) ^ 2) with (near ^ 2 * side (K i l) ^ 2) by ring.
    rewrite Q. unfold Rdiv. ring. }
  rewrite E, D.
  assert (A1 : - Rabs G <= G) by (pose proof (Rle_abs (- G)); rewrite Rabs_Ropp in *; lra).
  pose proof (Rle_abs (lone (fun l => b l / T))) as A2. pose proof (Rle_abs (lone c)) as A3.
  pose proof (Rabs_pos (lone (fun l => b l / T))) as A4.
  assert (B1 : near ^ 2 * lone (fun l => b l / T) <= near * Rabs (lone (fun l => b l / T))).
  { apply Rle_trans with (near ^ 2 * Rabs (lone (fun l => b l / T))).
    - apply Rmult_le_compat_l; [apply pow2_ge_0 | exact A2].
    - apply Rmult_le_compat_r; [exact A4 | simpl; nra]. }
  assert (B2 : near * lone c <= near * Rabs (lone c)) by (apply Rmult_le_compat_l; lra).
  assert (B3 : near * - Rabs G <= near * G) by (apply Rmult_le_compat_l; lra).
  assert (B4 : b i * far ^ 2 / T <= far * (short / 2)).
  { replace (b i * far ^ 2 / T) with (far * (b i * far / T)) by (unfold Rdiv; ring).
    apply Rmult_le_compat_l; lra. }
  assert (B5 : near * W = near * Rabs G + 2 * (near * Rabs (lone (fun l => b l / T))) +
               2 * (near * Rabs (lone c))) by (unfold W; ring).
  assert (B6 : near * W < far * short) by nra.
  assert (B7 : far * (2 * coulomb_needed n K delta i) = 2 * (far * short) + 2 * (c i * far))
    by (unfold short; ring).
  lra.
Qed.
