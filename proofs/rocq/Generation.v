(** * Generated energy in one interval: (19)-(22), what holds and what replaces (22). *)

From Coq Require Import Reals Lra Lia Psatz.
From Passivity Require Import Definitions Quantizer.
Open Scope R_scope.

(** EQ-19/20 (definition): (19) with (20) is the work of the held force plus the
    gain of the quantized spring, which is (18) once integrated. *)
Theorem EQ_19_20_by_definition : forall x0 x1,
  generated (held_force x0) x0 x1 (quantized_potential x0) (quantized_potential x1)
  = generated_quantized x0 x1.
Proof.
  intros. unfold generated, generated_quantized, quantization_effect, quantized_potential,
    linear_potential, quantization_potential, held_force, measured, ticks.
  unfold residue. nra.
Qed.

(** EQ-19/20 (short form): E_g is also D^2/2 + D(rho_1 - 1/2). *)
Theorem EQ_19_20_short : forall x0 x1,
  generated_quantized x0 x1
  = ticks x0 x1 ^ 2 / 2 + ticks x0 x1 * (residue x1 - 1 / 2).
Proof.
  intros. unfold generated_quantized, quantization_effect, ticks, residue. nra.
Qed.

(** The linear counterpart's generated energy is (18) with the linear spring. *)
Theorem TH_LIN_by_definition : forall x0 x1,
  generated (held_force x0) x0 x1 (linear_potential x0) (linear_potential x1)
  = generated_linear x0 x1.
Proof.
  intros. unfold generated, generated_linear, linear_potential, held_force, measured, residue.
  nra.
Qed.

(** EQ-21a: E_gq is at most |D|/2. *)
Theorem EQ_21a : forall x0 x1, quantization_effect x0 x1 <= bound_21 (ticks x0 x1).
Proof.
  intros. unfold quantization_effect, bound_21.
  pose proof (residue_bounds x0). pose proof (Rle_abs (ticks x0 x1)).
  pose proof (Rle_abs (- ticks x0 x1)) as H1. rewrite Rabs_Ropp in H1.
  pose proof (pow2_ge_0 (residue x1 - residue x0)).
  destruct (Rle_lt_dec 0 (ticks x0 x1)); nra.
Qed.

(** TH-LIN: against the linear spring the printed bound (22) is true. *)
Theorem TH_LIN : forall x0 x1, generated_linear x0 x1 <= bound_22 (x1 - x0).
Proof.
  intros. unfold generated_linear, bound_22.
  pose proof (residue_bounds x0). set (d := x1 - x0).
  pose proof (Rle_abs d). pose proof (Rle_abs (- d)) as H1. rewrite Rabs_Ropp in H1.
  destruct (Rle_lt_dec 0 d); nra.
Qed.

(** TH-LIN (tight): equality for a step back from a tick's lower edge. *)
Theorem TH_LIN_attained : forall z d, d <= 0 ->
  generated_linear (IZR z) (IZR z + d) = bound_22 d.
Proof.
  intros z d Hd. unfold generated_linear, bound_22. rewrite residue_IZR.
  replace (IZR z + d - IZR z) with d by ring. rewrite Rabs_left1 by lra. lra.
Qed.

(** TH-LIN (tight): and for a step forward it is approached as rho_0 tends to 1. *)
Theorem TH_LIN_approached : forall d eps, 0 < d -> 0 < eps ->
  exists x0, bound_22 d - eps < generated_linear x0 (x0 + d).
Proof.
  intros d eps Hd He. set (r := Rmin (1 / 2) (eps / (2 * d))).
  assert (0 < eps / (2 * d)) by (apply Rdiv_lt_0_compat; lra).
  assert (Hr : 0 < r <= 1 / 2) by (unfold r, Rmin; destruct Rle_dec; lra).
  exists (1 - r). unfold generated_linear, bound_22, residue.
  rewrite (floor_unique (1 - r) 0) by lra.
  replace (1 - r + d - (1 - r)) with d by ring. rewrite Rabs_right by lra.
  assert (r * d <= eps / 2).
  { apply Rle_trans with (eps / (2 * d) * d).
    - apply Rmult_le_compat_r; [lra | apply Rmin_r].
    - right. field. lra. }
  nra.
Qed.

(** TH-TELESCOPE: the two counterparts differ by a change of a potential in [0, 1/8]. *)
Theorem TH_TELESCOPE : forall x0 x1,
  generated_quantized x0 x1 - generated_linear x0 x1
  = quantization_potential x1 - quantization_potential x0.
Proof.
  intros. unfold generated_quantized, generated_linear, quantization_effect,
    quantization_potential, ticks, residue. nra.
Qed.

(** TH-TELESCOPE (the potential): it lies between 0 and 1/8. *)
Theorem TH_TELESCOPE_bounds : forall x, 0 <= quantization_potential x <= 1 / 8.
Proof.
  intro x. unfold quantization_potential. pose proof (residue_bounds x).
  pose proof (pow2_ge_0 (residue x - 1 / 2)). split; nra.
Qed.

(** TH-TELESCOPE (runs): over any number of intervals the difference is at most 1/8. *)
Theorem TH_TELESCOPE_run : forall (x : nat -> R) n,
  Rabs (sum_to n (fun h => generated_quantized (x (pred h)) (x h))
        - sum_to n (fun h => generated_linear (x (pred h)) (x h))) <= 1 / 8.
Proof.
  intros x n.
  assert (E : sum_to n (fun h => generated_quantized (x (pred h)) (x h))
        - sum_to n (fun h => generated_linear (x (pred h)) (x h))
        = quantization_potential (x n) - quantization_potential (x O)).
  { induction n as [| n IH]; simpl; [lra |].
    pose proof (TH_TELESCOPE (x n) (x (S n))) as T. set (u := sum_to n _) in *. set (w := sum_to n _) in *. simpl in IH. lra. }
  rewrite E. pose proof (TH_TELESCOPE_bounds (x n)). pose proof (TH_TELESCOPE_bounds (x O)).
  apply Rabs_le. lra.
Qed.

(** The ticks crossed are the whole part of |d|, or one more. *)
Lemma ticks_cases_up : forall x0 x1, x0 <= x1 ->
  ticks x0 x1 = floor (x1 - x0) \/ ticks x0 x1 = floor (x1 - x0) + 1.
Proof.
  intros x0 x1 H. pose proof (floor_spec x0). pose proof (floor_spec x1).
  pose proof (floor_spec (x1 - x0)).
  destruct (floor_integer x0) as [a Ha]. destruct (floor_integer x1) as [b Hb].
  destruct (floor_integer (x1 - x0)) as [c Hc]. unfold ticks. rewrite Ha, Hb, Hc in *.
  destruct (integer_zero_or_one (b - a - c)); rewrite ?minus_IZR in *; lra.
Qed.

(** TH-QUANT: the bound that replaces (22) for the paper's own counterpart. *)
Theorem TH_QUANT : forall x0 x1, generated_quantized x0 x1 <= bound_quantized (x1 - x0).
Proof.
  intros x0 x1. rewrite EQ_19_20_short. unfold bound_quantized, bound_22.
  pose proof (residue_bounds x0) as R0. pose proof (residue_bounds x1) as R1.
  assert (E : x1 - x0 = ticks x0 x1 + residue x1 - residue x0) by (unfold ticks, residue; ring).
  destruct (Rle_lt_dec x0 x1) as [H | H].
  - rewrite Rabs_right by lra. pose proof (residue_bounds (x1 - x0)) as Rf.
    assert (F : x1 - x0 = floor (x1 - x0) + residue (x1 - x0)) by (unfold residue; ring).
    assert (P : 0 <= floor (x1 - x0)).
    { rewrite <- (floor_IZR 0). apply floor_monotone. lra. }
    set (f := residue (x1 - x0)) in *. set (N := floor (x1 - x0)) in *.
    destruct (ticks_cases_up x0 x1 H) as [D | D]; fold N in D; rewrite D in *; nra.
  - rewrite Rabs_left by lra. replace (- (x1 - x0)) with (x0 - x1) by ring.
    pose proof (residue_bounds (x0 - x1)) as Rf.
    assert (F : x0 - x1 = floor (x0 - x1) + residue (x0 - x1)) by (unfold residue; ring).
    assert (P : 0 <= floor (x0 - x1)).
    { rewrite <- (floor_IZR 0). apply floor_monotone. lra. }
    set (f := residue (x0 - x1)) in *. set (N := floor (x0 - x1)) in *.
    assert (D' : ticks x0 x1 = - ticks x1 x0) by (unfold ticks; ring).
    destruct (ticks_cases_up x1 x0) as [D | D]; [lra | |];
      fold N in D; rewrite D', D in *; nra.
Qed.

(** TH-QUANT (tight): a step back by any d from a tick's lower edge attains the bound. *)
Theorem TH_QUANT_attained : forall z d, d <= 0 ->
  generated_quantized (IZR z) (IZR z + d) = bound_quantized d.
Proof.
  intros z d Hd. rewrite EQ_19_20_short. unfold bound_quantized, bound_22, ticks, residue.
  rewrite (Rplus_comm (IZR z) d), floor_shift, floor_IZR. rewrite Rabs_left1 by lra.
  pose proof (floor_spec d) as Fd. destruct (floor_integer d) as [n Hn]. rewrite Hn in *.
  destruct (Req_dec (IZR n) d) as [I | I].
  - replace (- d) with (IZR (- n)) by (rewrite opp_IZR; lra). rewrite floor_IZR, opp_IZR.
    rewrite <- I. nra.
  - rewrite (floor_unique (- d) (- n - 1)) by (rewrite minus_IZR, opp_IZR; lra).
    rewrite minus_IZR, opp_IZR. nra.
Qed.

(** TH-QUANT (tight): for a step forward the bound is approached as rho_0 tends to 1. *)
Theorem TH_QUANT_approached : forall d eps, 0 < d -> 0 < eps ->
  exists x0, bound_quantized d - eps < generated_quantized x0 (x0 + d).
Proof.
  intros d eps Hd He. unfold bound_quantized, bound_22. rewrite Rabs_right by lra.
  assert (F : d = floor d + residue d) by (unfold residue; ring).
  pose proof (residue_bounds d) as Rf. destruct (floor_integer d) as [N HN].
  assert (P : 0 <= IZR N).
  { rewrite <- HN, <- (floor_IZR 0). apply floor_monotone. lra. }
  set (f := residue d) in *. rewrite HN in F.
  assert (Q : 0 < eps / (2 * (d + 1))) by (apply Rdiv_lt_0_compat; lra).
  assert (S : forall r, r <= eps / (2 * (d + 1)) -> r * (d + 1) <= eps / 2).
  { intros r Hr. apply Rle_trans with (eps / (2 * (d + 1)) * (d + 1)).
    - apply Rmult_le_compat_r; lra.
    - right. field. lra. }
  destruct (Req_dec f 0) as [Z | Z].
  - set (r := Rmin (1 / 2) (eps / (2 * (d + 1)))).
    assert (Hr : 0 < r <= 1 / 2) by (unfold r, Rmin; destruct Rle_dec; lra).
    assert (Sr : r * (d + 1) <= eps / 2) by (apply S, Rmin_r).
    exists (1 - r). rewrite EQ_19_20_short. unfold ticks.
    unfold residue. replace d with (IZR N) by lra. rewrite floor_shift.
    rewrite (floor_unique (1 - r) 0) by lra. rewrite Z in *. nra.
  - set (r := Rmin f (eps / (2 * (d + 1)))).
    assert (Hr : 0 < r <= f) by (unfold r, Rmin; destruct Rle_dec; lra).
    assert (Sr : r * (d + 1) <= eps / 2) by (apply S, Rmin_r).
    exists (1 - r). rewrite EQ_19_20_short. unfold ticks, residue.
    replace (1 - r + d) with (1 - r + f + IZR N) by lra. rewrite floor_shift.
    rewrite (floor_unique (1 - r) 0) by lra.
    rewrite (floor_unique (1 - r + f) 1) by lra.
    replace d with (IZR N + f) in * by lra. nra.
Qed.
