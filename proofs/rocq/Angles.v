(** * Angles: what a linear digital controller costs over a motion, by finitely many angles.

    The controller is given by the sum [H] = H(1) of its response and the tail sums g_j = c_j +
    c_(j+1) + ...  A step [d] after the displacements [s] (s 1 the latest) costs H d^2 / 2 +
    d (g_1 s_1 + ... + g_n s_n).  Over any finite motion the costs add up to at most lambda
    times the sum of squares, if [symbol] is at most lambda at every angle. *)

From Coq Require Import Reals Lra Lia Psatz.
From Passivity Require Import Definitions History.
Open Scope R_scope.

(** H(1)/2 + g_1 cos theta + ... + g_n cos (n theta): the cost at one frequency. *)
Definition symbol (H : R) (g : nat -> R) (n : nat) (theta : R) : R :=
  H / 2 + sum_to n (fun j => g j * cos (INR j * theta)).

(** What a step [d] after the displacements [s] generates, without quantization. *)
Definition step_cost (H : R) (g : nat -> R) (n : nat) (d : R) (s : nat -> R) : R :=
  H * d ^ 2 / 2 + d * sum_to n (fun j => g j * s j).

(** The cost of the last [L] steps. *)
Definition total_cost (H : R) (g : nat -> R) (n L : nat) (s : nat -> R) : R :=
  sum_to L (fun i => step_cost H g n (s i) (fun j => s (i + j)%nat)).

Definition sum_of_squares (L : nat) (s : nat -> R) : R := sum_to L (fun i => s i ^ 2).

(** ** Finite sums *)

Lemma sum_to_scal : forall n a f, sum_to n (fun j => a * f j) = a * sum_to n f.
Proof. intros. induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.

Lemma sum_to_const : forall n a, sum_to n (fun _ => a) = INR n * a.
Proof. intros. induction n as [| n IH]; [simpl; ring |]. rewrite S_INR. simpl. rewrite IH. ring. Qed.

Lemma sum_to_swap : forall n m (f : nat -> nat -> R),
  sum_to n (fun i => sum_to m (fun j => f i j)) = sum_to m (fun j => sum_to n (fun i => f i j)).
Proof.
  intros n m f. induction n as [| n IH]; simpl.
  - symmetry. apply sum_to_zero. reflexivity.
  - rewrite IH, <- sum_to_plus. reflexivity.
Qed.

Lemma sum_to_le : forall n f g, (forall j, (1 <= j <= n)%nat -> f j <= g j) ->
  sum_to n f <= sum_to n g.
Proof.
  intros n f g. induction n as [| n IH]; intro H; simpl; [lra |].
  apply Rplus_le_compat; [apply IH; intros; apply H; lia | apply H; lia].
Qed.

Lemma sum_to_extend : forall n m f, (n <= m)%nat -> (forall j, (n < j)%nat -> f j = 0) ->
  sum_to m f = sum_to n f.
Proof.
  intros n m f L Z. induction L as [| m L IH]; [reflexivity |].
  simpl. rewrite IH, Z by lia. ring.
Qed.

Lemma sum_to_single : forall n k f, (1 <= k <= n)%nat ->
  (forall j, (1 <= j <= n)%nat -> j <> k -> f j = 0) -> sum_to n f = f k.
Proof.
  intros n k f. induction n as [| n IH]; intros Hk Z; [lia |]. simpl.
  destruct (Nat.eq_dec k (S n)) as [-> | N].
  - rewrite sum_to_zero; [ring | intros; apply Z; lia].
  - rewrite IH, (Z (S n)) by (try lia; intros; apply Z; lia). ring.
Qed.

Lemma sum_of_squares_nonneg : forall L s, 0 <= sum_of_squares L s.
Proof. intros. apply sum_to_nonneg. intros. apply pow2_ge_0. Qed.

(** ** M equally spaced angles *)

Definition angle (M m : nat) : R := 2 * PI * INR m / INR M.

(** TH-LTI (angles): the cosines of a multiple that is no whole turn cancel. *)
Lemma cosines_cancel : forall M k, (0 < k < M)%nat ->
  sum_to M (fun m => cos (INR k * angle M m)) = 0.
Proof.
  intros M k Hk. set (x := PI * INR k / INR M).
  assert (M0 : 0 < INR M) by (apply lt_0_INR; lia).
  assert (K0 : 0 < INR k) by (apply lt_0_INR; lia).
  assert (KM : INR k < INR M) by (apply lt_INR; lia).
  pose proof PI_RGT_0 as P0.
  assert (X : 0 < x < PI).
  { unfold x. split; [apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; assumption |].
    apply Rmult_lt_reg_r with (INR M); [exact M0 |].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. rewrite Rmult_1_r.
    apply Rmult_lt_compat_l; assumption. }
  pose proof (sin_gt_0 x (proj1 X) (proj2 X)) as S0.
  assert (T : forall n, 2 * sin x * sum_to n (fun m => cos (INR k * angle M m))
                        = sin ((2 * INR n + 1) * x) - sin x).
  { induction n as [| n IH].
    - simpl. replace ((2 * 0 + 1) * x) with x by ring. ring.
    - rewrite sum_to_S, Rmult_plus_distr_l, IH.
      replace (INR k * angle M (S n)) with (2 * INR (S n) * x)
        by (unfold angle, x; field; lra).
      rewrite S_INR. set (y := 2 * (INR n + 1) * x).
      replace ((2 * INR n + 1) * x) with (y - x) by (unfold y; ring).
      replace ((2 * (INR n + 1) + 1) * x) with (y + x) by (unfold y; ring).
      rewrite sin_minus, sin_plus. ring. }
  specialize (T M).
  replace ((2 * INR M + 1) * x) with (x + 2 * INR k * PI) in T by (unfold x; field; lra).
  rewrite sin_period in T.
  apply Rmult_eq_reg_l with (2 * sin x); [rewrite T; ring | lra].
Qed.

Lemma cosine_products : forall M j k, (1 <= j)%nat -> (1 <= k)%nat -> (j + k < M)%nat ->
  sum_to M (fun m => cos (INR j * angle M m) * cos (INR k * angle M m))
  = if Nat.eq_dec j k then INR M / 2 else 0.
Proof.
  intros M j k Hj Hk HM.
  assert (E : forall a b, (b <= a)%nat -> forall t,
    cos (INR a * t) * cos (INR b * t) = / 2 * (cos (INR (a - b) * t) + cos (INR (a + b) * t))).
  { intros a b Hab t. rewrite minus_INR, plus_INR by exact Hab.
    rewrite Rmult_minus_distr_r, Rmult_plus_distr_r, cos_minus, cos_plus. field. }
  assert (G : forall a b, (1 <= b <= a)%nat -> (a + b < M)%nat ->
    sum_to M (fun m => cos (INR a * angle M m) * cos (INR b * angle M m))
    = if Nat.eq_dec a b then INR M / 2 else 0).
  { intros a b Hab HM'.
    rewrite (sum_to_ext M _ (fun m => / 2 * (cos (INR (a - b) * angle M m)
      + cos (INR (a + b) * angle M m)))) by (intros; apply E; lia).
    rewrite sum_to_scal, sum_to_plus, (cosines_cancel M (a + b)) by lia.
    destruct (Nat.eq_dec a b) as [-> | N].
    - rewrite Nat.sub_diag.
      rewrite (sum_to_ext M _ (fun _ => 1))
        by (intros; simpl (INR 0); rewrite Rmult_0_l; apply cos_0).
      rewrite sum_to_const. field.
    - rewrite cosines_cancel by lia. ring. }
  destruct (Nat.le_ge_cases k j) as [O | O]; [apply G; lia |].
  rewrite (sum_to_ext M _ (fun m => cos (INR k * angle M m) * cos (INR j * angle M m)))
    by (intros; ring).
  rewrite G by lia. destruct (Nat.eq_dec k j), (Nat.eq_dec j k); congruence || reflexivity.
Qed.

Section Symbol.

Variables (H : R) (g : nat -> R) (n : nat).

Definition tail_within (k : nat) : R := if Nat.leb k n then g k else 0.

Lemma symbol_mean : forall M, (n < M)%nat ->
  sum_to M (fun m => symbol H g n (angle M m)) = INR M * (H / 2).
Proof.
  intros M HM. unfold symbol. rewrite sum_to_plus, sum_to_const, sum_to_swap.
  rewrite (sum_to_zero n); [ring |]. intros j Hj.
  rewrite sum_to_scal, cosines_cancel by lia. ring.
Qed.

Lemma symbol_correlation : forall M k, (1 <= k)%nat -> (n + k < M)%nat ->
  sum_to M (fun m => symbol H g n (angle M m) * cos (INR k * angle M m))
  = INR M / 2 * tail_within k.
Proof.
  intros M k Hk HM.
  rewrite (sum_to_ext M _ (fun m => H / 2 * cos (INR k * angle M m)
    + sum_to n (fun j => g j * (cos (INR j * angle M m) * cos (INR k * angle M m))))).
  2: { intros m _. unfold symbol. rewrite Rmult_plus_distr_r. f_equal.
       rewrite Rmult_comm, <- sum_to_scal. apply sum_to_ext. intros. ring. }
  rewrite sum_to_plus, sum_to_scal, cosines_cancel, sum_to_swap by lia.
  rewrite (sum_to_ext n _ (fun j => g j * (if Nat.eq_dec j k then INR M / 2 else 0))).
  2: { intros j Hj. rewrite sum_to_scal, cosine_products by lia. reflexivity. }
  unfold tail_within. destruct (Nat.leb_spec k n) as [I | O].
  - rewrite (sum_to_single n k); [| lia |].
    + destruct (Nat.eq_dec k k); [field | contradiction].
    + intros j _ N. destruct (Nat.eq_dec j k); [contradiction | ring].
  - rewrite sum_to_zero; [ring |]. intros j Hj. destruct (Nat.eq_dec j k); [lia | ring].
Qed.

(** ** The motion's transform at an angle *)

Definition wave_cos (L : nat) (s : nat -> R) (t : R) : R := sum_to L (fun i => s i * cos (INR i * t)).
Definition wave_sin (L : nat) (s : nat -> R) (t : R) : R := sum_to L (fun i => s i * sin (INR i * t)).

Definition wave_power (L : nat) (s : nat -> R) (t : R) : R :=
  wave_cos L s t ^ 2 + wave_sin L s t ^ 2.

Lemma wave_power_first : forall L s t,
  wave_power (S L) s t
  = s 1%nat ^ 2 + 2 * s 1%nat * wave_cos L (fun i => s (S i)) t
    + wave_power L (fun i => s (S i)) t.
Proof.
  intros L s t. set (u := fun i => s (S i)).
  assert (C : wave_cos (S L) s t
    = cos t * (s 1%nat + wave_cos L u t) - sin t * wave_sin L u t).
  { unfold wave_cos, wave_sin. rewrite sum_to_first. simpl (INR 1). rewrite Rmult_1_l.
    rewrite Rmult_plus_distr_l, <- !sum_to_scal.
    rewrite (sum_to_ext L (fun i => s (S i) * cos (INR (S i) * t))
      (fun i => cos t * (u i * cos (INR i * t)) + - (sin t * (u i * sin (INR i * t))))).
    - rewrite sum_to_plus. rewrite (sum_to_ext L (fun i => - (sin t * (u i * sin (INR i * t))))
        (fun i => (- 1) * (sin t * (u i * sin (INR i * t))))) by (intros; ring).
      rewrite (sum_to_scal L (- 1)). ring.
    - intros i _. unfold u. rewrite S_INR.
      replace ((INR i + 1) * t) with (INR i * t + t) by ring. rewrite cos_plus. ring. }
  assert (D : wave_sin (S L) s t
    = sin t * (s 1%nat + wave_cos L u t) + cos t * wave_sin L u t).
  { unfold wave_cos, wave_sin. rewrite sum_to_first. simpl (INR 1). rewrite Rmult_1_l.
    rewrite Rmult_plus_distr_l, <- !sum_to_scal.
    rewrite (sum_to_ext L (fun i => s (S i) * sin (INR (S i) * t))
      (fun i => sin t * (u i * cos (INR i * t)) + cos t * (u i * sin (INR i * t)))).
    - rewrite sum_to_plus. ring.
    - intros i _. unfold u. rewrite S_INR.
      replace ((INR i + 1) * t) with (INR i * t + t) by ring. rewrite sin_plus. ring. }
  unfold wave_power. rewrite C, D.
  pose proof (sin2_cos2 t) as Q. unfold Rsqr in Q.
  set (p := s 1%nat + wave_cos L u t). set (q := wave_sin L u t).
  replace ((cos t * p - sin t * q) ^ 2 + (sin t * p + cos t * q) ^ 2)
    with ((sin t * sin t + cos t * cos t) * (p ^ 2 + q ^ 2)) by ring.
  rewrite Q. unfold p, q. ring.
Qed.

(** TH-LTI (angles): the cost of a finite motion is exactly the mean, over more than L + n
    equally spaced angles, of the symbol weighted with the power of the motion's transform. *)
Theorem TH_LTI_angles : forall M L s, (L + n < M)%nat -> (forall i, (L < i)%nat -> s i = 0) ->
  INR M * total_cost H g n L s
  = sum_to M (fun m => symbol H g n (angle M m) * wave_power L s (angle M m)).
Proof.
  intros M L. induction L as [| L IH]; intros s HM Z.
  - unfold total_cost, wave_power, wave_cos, wave_sin. simpl. rewrite Rmult_0_r.
    symmetry. apply sum_to_zero. intros. ring.
  - set (u := fun i => s (S i)).
    rewrite (sum_to_ext M _ (fun m => s 1%nat ^ 2 * symbol H g n (angle M m)
      + (2 * s 1%nat) * (symbol H g n (angle M m) * wave_cos L u (angle M m))
      + symbol H g n (angle M m) * wave_power L u (angle M m))).
    2: { intros m _. rewrite wave_power_first. unfold u. ring. }
    rewrite !sum_to_plus, !sum_to_scal, symbol_mean by lia.
    rewrite <- IH by (try lia; intros i Hi; unfold u; apply Z; lia).
    assert (E : sum_to M (fun m => symbol H g n (angle M m) * wave_cos L u (angle M m))
                = INR M / 2 * sum_to n (fun j => g j * u j)).
    { unfold wave_cos.
      rewrite (sum_to_ext M _ (fun m => sum_to L (fun i =>
        u i * (symbol H g n (angle M m) * cos (INR i * angle M m))))).
      2: { intros m _. rewrite <- sum_to_scal. apply sum_to_ext. intros. ring. }
      rewrite sum_to_swap.
      rewrite (sum_to_ext L _ (fun i => INR M / 2 * (tail_within i * u i))).
      2: { intros i Hi. rewrite sum_to_scal, symbol_correlation by lia. ring. }
      rewrite sum_to_scal. f_equal.
      transitivity (sum_to (L + n) (fun i => tail_within i * u i)).
      - symmetry. apply sum_to_extend; [lia |]. intros j Hj. unfold u. rewrite Z by lia. ring.
      - rewrite (sum_to_extend n).
        + apply sum_to_ext. intros j Hj. unfold tail_within.
          destruct (Nat.leb_spec j n); [reflexivity | lia].
        + lia.
        + intros j Hj. unfold tail_within. destruct (Nat.leb_spec j n); [lia | ring]. }
    rewrite E. unfold total_cost. rewrite sum_to_first. unfold step_cost at 1.
    change (fun i => step_cost H g n (s (S i)) (fun j => s (S i + j)%nat))
      with (fun i => step_cost H g n (u i) (fun j => u (i + j)%nat)).
    change (fun j => g j * s (1 + j)%nat) with (fun j => g j * u j). field.
Qed.

End Symbol.

(** TH-LTI (form): if the symbol is at most lambda at every angle, a finite motion costs at most
    lambda times its sum of squares. *)
Theorem TH_LTI_form : forall H g n lambda L s,
  (forall theta, symbol H g n theta <= lambda) -> (forall i, (L < i)%nat -> s i = 0) ->
  total_cost H g n L s <= lambda * sum_of_squares L s.
Proof.
  intros H g n lambda L s B Z. set (M := S (L + n)).
  assert (M0 : 0 < INR M) by (apply lt_0_INR; unfold M; lia).
  pose proof (TH_LTI_angles H g n M L s ltac:(unfold M; lia) Z) as E.
  assert (Q : INR M * sum_of_squares L s = sum_to M (fun m => wave_power L s (angle M m))).
  { pose proof (TH_LTI_angles 2 g 0 M L s ltac:(unfold M; lia) Z) as P.
    replace (total_cost 2 g 0 L s) with (sum_of_squares L s) in P.
    - rewrite P. apply sum_to_ext. intros m _. unfold symbol. simpl sum_to. field.
    - apply sum_to_ext. intros i _. unfold step_cost. simpl sum_to. field. }
  apply Rmult_le_reg_l with (INR M); [exact M0 |].
  rewrite E. replace (INR M * (lambda * sum_of_squares L s))
    with (lambda * (INR M * sum_of_squares L s)) by ring.
  rewrite Q, <- sum_to_scal. apply sum_to_le. intros m _.
  apply Rmult_le_compat_r; [| apply B].
  unfold wave_power. pose proof (pow2_ge_0 (wave_cos L s (angle M m))).
  pose proof (pow2_ge_0 (wave_sin L s (angle M m))). lra.
Qed.

(** Tails beyond the motion's length do not matter. *)
Lemma total_cost_order : forall H g n m L s, (L <= n)%nat -> (L <= m)%nat ->
  (forall i, (L < i)%nat -> s i = 0) -> total_cost H g n L s = total_cost H g m L s.
Proof.
  intros H g n m L s Hn Hm Z. apply sum_to_ext. intros i Hi. unfold step_cost.
  assert (E : forall k, (L <= k)%nat -> sum_to k (fun j => g j * s (i + j)%nat)
                        = sum_to L (fun j => g j * s (i + j)%nat)).
  { intros k Hk. apply sum_to_extend; [exact Hk |]. intros j Hj. rewrite Z by lia. ring. }
  rewrite (E n Hn), (E m Hm). reflexivity.
Qed.

(** The symbol of a response that may never end is at most lambda: long enough truncations
    exceed lambda by as little as one likes. *)
Definition symbol_at_most (H : R) (g : nat -> R) (lambda : R) : Prop :=
  forall eps n, 0 < eps -> exists m, (n <= m)%nat /\
  forall theta, symbol H g m theta <= lambda + eps.

Lemma symbol_at_most_finite : forall H g n lambda, (forall j, (n < j)%nat -> g j = 0) ->
  (forall theta, symbol H g n theta <= lambda) -> symbol_at_most H g lambda.
Proof.
  intros H g n lambda Z B eps m He. exists (n + m)%nat. split; [lia |]. intro theta.
  specialize (B theta). unfold symbol in *.
  rewrite (sum_to_extend n (n + m)) by (try lia; intros j Hj; rewrite Z by lia; ring). lra.
Qed.

(** TH-LTI (form, limit): the same for a response that may never end. *)
Theorem TH_LTI_form_limit : forall H g lambda n L s,
  symbol_at_most H g lambda -> (L <= n)%nat -> (forall i, (L < i)%nat -> s i = 0) ->
  total_cost H g n L s <= lambda * sum_of_squares L s.
Proof.
  intros H g lambda n L s B Hn Z.
  pose proof (sum_of_squares_nonneg L s) as Q0. set (q := sum_of_squares L s) in *.
  apply Rnot_lt_le. intro C.
  set (gap := total_cost H g n L s - lambda * q) in *.
  assert (G : 0 < gap) by (unfold gap; lra).
  destruct (B (gap / (q + 1)) L) as (m & Hm & Bm).
  { apply Rdiv_lt_0_compat; lra. }
  pose proof (TH_LTI_form H g m _ L s Bm Z) as T. fold q in T.
  rewrite <- (total_cost_order H g n m L s Hn Hm Z) in T.
  assert (E : gap / (q + 1) * q < gap).
  { apply Rmult_lt_reg_r with (q + 1); [lra |].
    replace (gap / (q + 1) * q * (q + 1)) with (gap * q) by (field; lra). nra. }
  unfold gap in *. nra.
Qed.

(** No smaller bound than H(1)/2 will do, so lambda is not negative where H(1) is not. *)
Lemma lambda_at_least : forall H g lambda, symbol_at_most H g lambda -> H / 2 <= lambda.
Proof.
  intros H g lambda B.
  pose proof (TH_LTI_form_limit H g lambda 1 1 (fun i => if Nat.eqb i 1 then 1 else 0) B
    (le_n 1)) as T.
  assert (total_cost H g 1 1 (fun i => if Nat.eqb i 1 then 1 else 0) = H / 2)
    by (unfold total_cost, step_cost; simpl; field).
  assert (sum_of_squares 1 (fun i => if Nat.eqb i 1 then 1 else 0) = 1)
    by (unfold sum_of_squares; simpl; ring).
  rewrite H0, H1 in T. rewrite Rmult_1_r in T. apply T.
  intros [| [| i]] Hi; [lia | lia | reflexivity].
Qed.
