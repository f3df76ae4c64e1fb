(** * Box: tolerances.  What is decided at a few corners holds of every loop in the box.

    Friction at its least and all else at its most is hardest; but for the period T, which pulls
    both ways where there is damping behind an encoder: B Delta / T is largest at the shortest.
    Without an encoder Delta is 0 here, without an effect its parameter. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Model Law Combined Region.
Open Scope R_scope.

(** A margin as a function of the period: a constant less e T + g / T. *)
Lemma period_load_convex : forall e g T0 T T1, 0 <= e -> 0 <= g -> 0 < T0 -> T0 <= T <= T1 ->
  e * T + g / T <= Rmax (e * T0 + g / T0) (e * T1 + g / T1).
Proof.
  intros e g T0 T T1 He Hg H0 HT.
  assert (P0 : e * T0 + g / T0 - (e * T + g / T) = (T - T0) * (g / (T * T0) - e)) by (field; lra).
  assert (P1 : e * T1 + g / T1 - (e * T + g / T) = (T1 - T) * (e - g / (T * T1))) by (field; lra).
  assert (O : g / (T * T1) <= g / (T * T0)).
  { apply Rmult_le_compat_l; [exact Hg |]. apply Rinv_le_contravar; [nra |].
    apply Rmult_le_compat_l; lra. }
  destruct (Rle_lt_dec (g / (T * T1)) e) as [C | C].
  - eapply Rle_trans; [| apply Rmax_r].
    assert (0 <= (T1 - T) * (e - g / (T * T1))) by (apply Rmult_le_pos; lra). lra.
  - eapply Rle_trans; [| apply Rmax_l].
    assert (0 <= (T - T0) * (g / (T * T0) - e)) by (apply Rmult_le_pos; lra). lra.
Qed.

Section Box.

Variables b0 b1 c0 c1 K0 K1 T0 T1 D0 D1 B0 B1 F0 F1 : R.
Variable k : R.
Hypothesis K_pos : 0 < K0.
Hypothesis T_pos : 0 < T0.
Hypothesis D_nonneg : 0 <= D0.
Hypothesis B_nonneg : 0 <= B0.
Hypothesis k_nonneg : 0 <= k.

Record inside (b c K T D B F : R) : Prop := {
  b_in : b0 <= b <= b1;
  c_in : c0 <= c <= c1;
  K_in : K0 <= K <= K1;
  T_in : T0 <= T <= T1;
  D_in : D0 <= D <= D1;
  B_in : B0 <= B <= B1;
  F_in : F0 <= F <= F1
}.

(** The margin of a loop, and of the hardest one with period [T]. *)
Definition loop_margin (b c K T D B F v : R) : R :=
  margin (viscous_si b K T k B) (coulomb_si c K T D B F) v.

Lemma product_le : forall x y x' y', 0 <= x <= x' -> 0 <= y <= y' -> x * y <= x' * y'.
Proof. intros. apply Rmult_le_compat; lra. Qed.

(** No loop is harder than the hardest with its period, and none easier than the easiest. *)
Lemma corner_margin : forall b c K T D B F v, inside b c K T D B F -> 0 <= v ->
  loop_margin b0 c0 K1 T D1 B1 F1 v <= loop_margin b c K T D B F v
  <= loop_margin b1 c1 K0 T D0 B0 F0 v.
Proof.
  intros b c K T D B F v [Hb Hc HK HT HD HB HF] Hv.
  unfold loop_margin, margin, viscous_si, coulomb_si.
  assert (L : 0 <= T * (1 / 2 + k) * v) by (apply Rmult_le_pos; [nra | exact Hv]).
  assert (I : 0 <= / T) by (apply Rlt_le, Rinv_0_lt_compat; lra).
  assert (KL : K * (T * (1 / 2 + k) * v) <= K1 * (T * (1 / 2 + k) * v)
               /\ K0 * (T * (1 / 2 + k) * v) <= K * (T * (1 / 2 + k) * v))
    by (split; apply Rmult_le_compat_r; lra).
  assert (KD : K * D <= K1 * D1 /\ K0 * D0 <= K * D) by (split; apply product_le; lra).
  assert (BD : B * D * / T <= B1 * D1 * / T /\ B0 * D0 * / T <= B * D * / T)
    by (split; apply Rmult_le_compat_r; try exact I; apply product_le; lra).
  assert (bv : b0 * v <= b * v /\ b * v <= b1 * v) by (split; apply Rmult_le_compat_r; lra).
  assert (Bv : B0 * v <= B * v /\ B * v <= B1 * v) by (split; apply Rmult_le_compat_r; lra).
  unfold Rdiv in *. lra.
Qed.

(** At a speed, the hardest loops with the longest and the shortest period are enough. *)
Lemma hardest_periods : forall b c K T D B F v, inside b c K T D B F -> 0 <= v ->
  0 <= loop_margin b0 c0 K1 T1 D1 B1 F1 v -> 0 <= loop_margin b0 c0 K1 T0 D1 B1 F1 v ->
  0 <= loop_margin b c K T D B F v.
Proof.
  intros b c K T D B F v I Hv M1 M0.
  eapply Rle_trans; [| apply (corner_margin _ _ _ _ _ _ _ v I Hv)].
  destruct I as [Hb Hc HK HT HD HB HF].
  pose proof (period_load_convex (K1 * (1 / 2 + k) * v) (B1 * D1) T0 T T1) as P.
  assert (E : forall t, t <> 0 -> loop_margin b0 c0 K1 t D1 B1 F1 v
    = (b0 - B1) * v + (c0 - K1 * D1 / 2 - F1 / 2) - (K1 * (1 / 2 + k) * v * t + B1 * D1 / t)).
  { intros t Ht. unfold loop_margin, margin, viscous_si, coulomb_si. field. exact Ht. }
  rewrite E in * by lra.
  specialize (P ltac:(apply Rmult_le_pos; [nra | exact Hv])
                ltac:(apply Rmult_le_pos; lra) T_pos HT).
  revert P. unfold Rmax. destruct Rle_dec; lra.
Qed.

(** TH-REGION (box, holds): where the criterion holds up to the largest bound for the two
    hardest loops, it holds up to its own bound for every loop of the box. *)
Theorem TH_REGION_box_holds : forall W,
  holds_up_to (viscous_si b0 K1 T1 k B1) (coulomb_si c0 K1 T1 D1 B1 F1) W ->
  holds_up_to (viscous_si b0 K1 T0 k B1) (coulomb_si c0 K1 T0 D1 B1 F1) W ->
  forall b c K T D B F V, inside b c K T D B F -> V <= W ->
  holds_up_to (viscous_si b K T k B) (coulomb_si c K T D B F) V.
Proof.
  intros W H1 H0 b c K T D B F V I HV v Hv.
  apply (hardest_periods _ _ _ _ _ _ _ v I); [lra | apply H1; lra | apply H0; lra].
Qed.

(** The same at every speed. *)
Theorem TH_REGION_box_holds_at_all :
  holds_at_all (viscous_si b0 K1 T1 k B1) (coulomb_si c0 K1 T1 D1 B1 F1) ->
  holds_at_all (viscous_si b0 K1 T0 k B1) (coulomb_si c0 K1 T0 D1 B1 F1) ->
  forall b c K T D B F, inside b c K T D B F ->
  holds_at_all (viscous_si b K T k B) (coulomb_si c K T D B F).
Proof.
  intros H1 H0 b c K T D B F I v Hv.
  apply (hardest_periods _ _ _ _ _ _ _ v I); [lra | apply H1; lra | apply H0; lra].
Qed.

(** The easiest loop with period [T]. *)
Definition easiest_holds_up_to (T V : R) : Prop :=
  holds_up_to (viscous_si b1 K0 T k B0) (coulomb_si c1 K0 T D0 B0 F0) V.

Definition easiest_holds_at_all (T : R) : Prop :=
  holds_at_all (viscous_si b1 K0 T k B0) (coulomb_si c1 K0 T D0 B0 F0).

(** The periods that tell whether any in the interval meets the criterion. *)
Definition near_rest : R := shortest_period c1 K0 D0 B0 F0.
Definition at_bound (V : R) : R := best_period b1 c1 K0 D0 V k B0 F0.

Lemma easiest_near_rest : forall T, 0 < T -> 0 <= coulomb_si c1 K0 T D0 B0 F0 ->
  c1 - K0 * D0 / 2 - F0 / 2 <= 0 ->
  B0 * D0 = 0 /\ c1 - K0 * D0 / 2 - F0 / 2 = 0.
Proof.
  intros T HT C S. unfold coulomb_si in C.
  assert (G : 0 <= B0 * D0) by (apply Rmult_le_pos; lra).
  assert (Q : 0 <= B0 * D0 / T) by (apply Rmult_le_pos; [exact G | apply Rlt_le, Rinv_0_lt_compat, HT]).
  assert (Z : B0 * D0 / T = 0) by lra. split; [| lra].
  apply Rmult_eq_reg_r with (/ T); [rewrite Rmult_0_l; exact Z |].
  apply Rgt_not_eq, Rinv_0_lt_compat, HT.
Qed.

(** TH-REGION (box, fails): if the criterion holds for any loop of the box at every speed, it
    does for the easiest one with the shortest period, or with that which is just enough near
    rest; so where it does for neither, it does for no loop. *)
Theorem TH_REGION_box_fails_at_all : forall b c K T D B F, inside b c K T D B F ->
  holds_at_all (viscous_si b K T k B) (coulomb_si c K T D B F) ->
  exists t, (t = T0 \/ t = near_rest) /\ T0 <= t <= T1 /\ easiest_holds_at_all t.
Proof.
  intros b c K T D B F I H.
  assert (E : easiest_holds_at_all T).
  { intros v Hv. eapply Rle_trans; [apply (H v Hv) |].
    apply (corner_margin _ _ _ _ _ _ _ v I). lra. }
  destruct I as [Hb Hc HK HT HD HB HF].
  unfold easiest_holds_at_all in *. change holds_at_all with globally_stable in *.
  apply TH_REGION_all in E. destruct E as [V C].
  assert (Vt : forall t, t <= T -> 0 <= viscous_si b1 K0 t k B0).
  { intros t Ht. unfold viscous_si in *.
    assert (K0 * (1 / 2 + k) * t <= K0 * (1 / 2 + k) * T) by (apply Rmult_le_compat_l; nra). lra. }
  destruct (Rle_lt_dec (c1 - K0 * D0 / 2 - F0 / 2) 0) as [S | S].
  - destruct (easiest_near_rest T ltac:(lra) C S) as [G Z].
    exists T0. split; [left; reflexivity |]. split; [lra |]. apply TH_REGION_all. split; [apply Vt; lra |].
    unfold coulomb_si. rewrite G. unfold Rdiv. lra.
  - apply TH_STIFF_shortest in C; [| lra | exact S]. fold near_rest in C.
    destruct (Rle_lt_dec near_rest T0) as [N | N].
    + exists T0. split; [left; reflexivity |]. split; [lra |]. apply TH_REGION_all.
      split; [apply Vt; lra |]. apply TH_STIFF_shortest; [lra | exact S | exact N].
    + exists near_rest. split; [right; reflexivity |]. split; [lra |]. apply TH_REGION_all.
      split; [apply Vt; lra |]. apply TH_STIFF_shortest; [lra | exact S | apply Rle_refl].
Qed.

(** Towards the best period from either side the criterion at a speed is never lost. *)
Lemma towards_best : forall V t T, 0 < V -> 0 < t -> 0 < T ->
  Rabs (t - at_bound V) <= Rabs (T - at_bound V) ->
  0 <= loop_margin b1 c1 K0 T D0 B0 F0 V -> 0 <= loop_margin b1 c1 K0 t D0 B0 F0 V.
Proof.
  intros V t T HV Ht HT N M. unfold loop_margin in *.
  assert (He : 0 < K0 * (1 / 2 + k) * V) by (apply Rmult_lt_0_compat; [nra | exact HV]).
  pose proof (TH_STIFF_best b1 c1 K0 T D0 V k B0 F0 HT He) as PT.
  pose proof (TH_STIFF_best b1 c1 K0 t D0 V k B0 F0 Ht He) as Pt.
  fold (at_bound V) in *.
  assert (Q : (t - at_bound V) ^ 2 <= (T - at_bound V) ^ 2).
  { rewrite <- (pow2_abs (t - at_bound V)), <- (pow2_abs (T - at_bound V)).
    apply pow_incr. split; [apply Rabs_pos | exact N]. }
  apply Rmult_le_reg_l with t; [exact Ht |]. rewrite Rmult_0_r, Pt.
  assert (0 <= T * margin (viscous_si b1 K0 T k B0) (coulomb_si c1 K0 T D0 B0 F0) V)
    by (apply Rmult_le_pos; lra).
  rewrite PT in H.
  assert (K0 * (1 / 2 + k) * V * (T - at_bound V) ^ 2 >= K0 * (1 / 2 + k) * V * (t - at_bound V) ^ 2)
    by (apply Rle_ge, Rmult_le_compat_l; lra).
  lra.
Qed.

(** TH-REGION (box, fails up to a bound): if the criterion holds for any loop of the box up to
    any bound of its tolerance, it does up to the least bound for the easiest loop with one of
    four periods: the shortest, the longest, that which is just enough near rest, and the best
    at the bound. *)
Theorem TH_REGION_box_fails : forall W, 0 < W ->
  forall b c K T D B F V, inside b c K T D B F -> W <= V ->
  holds_up_to (viscous_si b K T k B) (coulomb_si c K T D B F) V ->
  exists t, (t = T0 \/ t = T1 \/ t = near_rest \/ t = at_bound W)
            /\ T0 <= t <= T1 /\ easiest_holds_up_to t W.
Proof.
  intros W HW b c K T D B F V I HV H.
  assert (E : easiest_holds_up_to T W).
  { intros v Hv. eapply Rle_trans; [apply (H v); lra |].
    apply (corner_margin _ _ _ _ _ _ _ v I). lra. }
  destruct I as [Hb Hc HK HT HD HB HF].
  apply TH_REGION_bound in E; [| exact HW]. destruct E as [C M].
  assert (Use : forall t, T0 <= t <= T1 -> 0 <= coulomb_si c1 K0 t D0 B0 F0 ->
    Rabs (t - at_bound W) <= Rabs (T - at_bound W) -> easiest_holds_up_to t W).
  { intros t Ht Ct N. apply TH_REGION_bound; [exact HW |]. split; [exact Ct |].
    apply (towards_best W t T HW); [lra | lra | exact N | exact M]. }
  destruct (Rle_lt_dec (c1 - K0 * D0 / 2 - F0 / 2) 0) as [S | S].
  { (* Nothing is left near rest, and the period does not matter there: the shortest is best. *)
    destruct (easiest_near_rest T ltac:(lra) C S) as [G Z].
    exists T0. split; [left; reflexivity |]. split; [lra |].
    apply TH_REGION_bound; [exact HW |].
    assert (Z0 : forall t, coulomb_si c1 K0 t D0 B0 F0 = 0).
    { intro t. unfold coulomb_si. rewrite G. unfold Rdiv. lra. }
    split; [rewrite Z0; lra |]. unfold margin in *. rewrite Z0 in *.
    unfold viscous_si in *.
    assert (K0 * (1 / 2 + k) * T0 <= K0 * (1 / 2 + k) * T) by (apply Rmult_le_compat_l; nra).
    assert ((b1 - K0 * T * (1 / 2 + k) - B0) * W <= (b1 - K0 * T0 * (1 / 2 + k) - B0) * W)
      by (apply Rmult_le_compat_r; lra). lra. }
  assert (Cn : near_rest <= T) by (apply (TH_STIFF_shortest c1 K0 T D0 B0 F0); [lra | exact S | exact C]).
  assert (Ct : forall t, 0 < t -> near_rest <= t -> 0 <= coulomb_si c1 K0 t D0 B0 F0).
  { intros t Ht N. apply TH_STIFF_shortest; [exact Ht | exact S | exact N]. }
  destruct (Rle_lt_dec T (at_bound W)) as [U | U].
  - (* Below the best period: go up, to it or to the end of the interval. *)
    destruct (Rle_lt_dec (at_bound W) T1) as [L | L].
    + exists (at_bound W). split; [right; right; right; reflexivity |]. split; [lra |].
      apply Use; [lra | apply Ct; lra |].
      replace (at_bound W - at_bound W) with 0 by ring. rewrite Rabs_R0. apply Rabs_pos.
    + exists T1. split; [right; left; reflexivity |]. split; [lra |].
      apply Use; [lra | apply Ct; lra |]. rewrite !Rabs_left1 by lra. lra.
  - (* Above it: go down, to it, to the end, or to where Coulomb friction is just enough. *)
    destruct (Rle_lt_dec T0 near_rest) as [N | N].
    + destruct (Rle_lt_dec near_rest (at_bound W)) as [Q | Q].
      * exists (at_bound W). split; [right; right; right; reflexivity |]. split; [lra |].
        apply Use; [lra | apply Ct; lra |].
        replace (at_bound W - at_bound W) with 0 by ring. rewrite Rabs_R0. apply Rabs_pos.
      * exists near_rest. split; [right; right; left; reflexivity |]. split; [lra |].
        apply Use; [lra | apply Ct; lra |]. rewrite !Rabs_right by lra. lra.
    + destruct (Rle_lt_dec T0 (at_bound W)) as [Q | Q].
      * exists (at_bound W). split; [right; right; right; reflexivity |]. split; [lra |].
        apply Use; [lra | apply Ct; lra |].
        replace (at_bound W - at_bound W) with 0 by ring. rewrite Rabs_R0. apply Rabs_pos.
      * exists T0. split; [left; reflexivity |]. split; [lra |].
        apply Use; [lra | apply Ct; lra |]. rewrite !Rabs_right by lra. lra.
Qed.

(** TH-REGION (box, region): every loop has coefficients between those of the four corners, so
    where these have one region, so has it. *)
Theorem TH_REGION_box_coefficients : forall b c K T D B F, inside b c K T D B F ->
  viscous_si b0 K1 T1 k B1 <= viscous_si b K T k B <= viscous_si b1 K0 T0 k B0
  /\ coulomb_si c0 K1 T0 D1 B1 F1 <= coulomb_si c K T D B F <= coulomb_si c1 K0 T1 D0 B0 F0.
Proof.
  intros b c K T D B F [Hb Hc HK HT HD HB HF]. unfold viscous_si, coulomb_si.
  assert (KT : K * T <= K1 * T1 /\ K0 * T0 <= K * T) by (split; apply product_le; lra).
  assert (KTk : K * T * (1 / 2 + k) <= K1 * T1 * (1 / 2 + k)
                /\ K0 * T0 * (1 / 2 + k) <= K * T * (1 / 2 + k))
    by (split; apply Rmult_le_compat_r; lra).
  assert (KD : K * D <= K1 * D1 /\ K0 * D0 <= K * D) by (split; apply product_le; lra).
  assert (BD : B * D <= B1 * D1 /\ B0 * D0 <= B * D) by (split; apply product_le; lra).
  assert (G : 0 <= B0 * D0) by (apply Rmult_le_pos; lra).
  assert (I0 : / T <= / T0) by (apply Rinv_le_contravar; lra).
  assert (I1 : / T1 <= / T) by (apply Rinv_le_contravar; lra).
  assert (P : 0 < / T1) by (apply Rinv_0_lt_compat; lra).
  assert (BDT : B * D * / T <= B1 * D1 * / T0 /\ B0 * D0 * / T1 <= B * D * / T)
    by (split; apply product_le; lra).
  unfold Rdiv in *. lra.
Qed.

End Box.
