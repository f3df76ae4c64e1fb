(** * ActuatorCost: kappa of TH-LATENCY and TH-LAG, decided without a root.

    A force that follows its command late, by m periods on average and with variance Var over the
    phase of the sample, costs kappa = ((1/2 + m) + sqrt ((1/2 + m)^2 + Var))/2 of viscous
    friction. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Definition actuator_cost (m Var : R) : R := ((1 / 2 + m) + sqrt ((1 / 2 + m) ^ 2 + Var)) / 2.

(** The two numbers of which the sign is decided. *)
Definition spare_mean (beta m : R) : R := beta - 1 / 2 - m.
Definition spare_square (beta m Var : R) : R := 4 * beta * (beta - 1 / 2 - m) - Var.

(** TH-LAG (squares): kappa is not above beta exactly when both are not negative. *)
Theorem TH_LAG_kappa_squares : forall beta m Var, 0 <= m -> 0 <= Var ->
  actuator_cost m Var <= beta <-> 0 <= spare_mean beta m /\ 0 <= spare_square beta m Var.
Proof.
  intros beta m Var Hm HV. unfold actuator_cost, spare_mean, spare_square.
  set (n := 1 / 2 + m). assert (n0 : 0 < n) by (unfold n; lra).
  assert (D0 : 0 <= n ^ 2 + Var) by nra.
  pose proof (sqrt_pos (n ^ 2 + Var)) as S0. pose proof (sqrt_sqrt _ D0) as SS.
  set (r := sqrt (n ^ 2 + Var)) in *.
  assert (R1 : n <= r) by (apply Rsqr_incr_0_var; [unfold Rsqr; nra | exact S0]).
  replace (beta - 1 / 2 - m) with (beta - n) by (unfold n; ring).
  split.
  - intro H. assert (L : r <= 2 * beta - n) by lra. split; [lra |]. nra.
  - intros [H1 H2]. apply Rmult_le_reg_l with 2; [lra |].
    assert (r <= 2 * beta - n); [| lra].
    apply Rsqr_incr_0_var; [unfold Rsqr; nra | lra].
Qed.

(** kappa itself: at least 1/2 + m, and the square is met exactly. *)
Theorem TH_LAG_kappa : forall m Var, 0 <= m -> 0 <= Var ->
  1 / 2 + m <= actuator_cost m Var /\ spare_square (actuator_cost m Var) m Var = 0.
Proof.
  intros m Var Hm HV. unfold actuator_cost, spare_square. set (n := 1 / 2 + m).
  assert (n0 : 0 < n) by (unfold n; lra). assert (D0 : 0 <= n ^ 2 + Var) by nra.
  pose proof (sqrt_pos (n ^ 2 + Var)) as S0. pose proof (sqrt_sqrt _ D0) as SS.
  set (r := sqrt (n ^ 2 + Var)) in *.
  assert (R1 : n <= r) by (apply Rsqr_incr_0_var; [unfold Rsqr; nra | exact S0]).
  split; [lra |]. replace ((n + r) / 2 - 1 / 2 - m) with ((r - n) / 2) by (unfold n; field). nra.
Qed.

(** More viscous friction than enough is enough. *)
Lemma spare_monotone : forall kappa beta m Var, 0 <= m -> kappa <= beta ->
  0 <= spare_mean kappa m -> 0 <= spare_square kappa m Var ->
  0 <= spare_mean beta m /\ 0 <= spare_square beta m Var.
Proof. intros kappa beta m Var Hm L. unfold spare_mean, spare_square. intros H1 H2. split; nra. Qed.

(** ** A fraction of a period: latency *)

Definition latency_variance (f : R) : R := f * (1 - f).

(** The share of the square of a displacement that is remembered. *)

Definition latency_memory (kappa f : R) : R := f / 2 + f * (1 - f) / (4 * kappa).

(** What is left for the first part of an interval, once the delayed part is paid. *)
Definition latency_first (kappa f : R) : R :=
  kappa / f - 1 / 2 - 1 / (4 * latency_memory kappa f).

(** TH-LATENCY (first part): a force y behind moves by [a] before the output changes. *)
Lemma latency_first_part : forall kappa f y a, 0 < f < 1 -> 0 < kappa ->
  y * a + a ^ 2 / 2 + latency_first kappa f * a ^ 2
  <= latency_memory kappa f * y ^ 2 + kappa * (a ^ 2 / f).
Proof.
  intros kappa f y a Hf Hk. unfold latency_first. set (p := latency_memory kappa f).
  assert (p0 : 0 < p).
  { unfold p, latency_memory. assert (0 < f * (1 - f) / (4 * kappa)); [| lra].
    apply Rdiv_lt_0_compat; nra. }
  assert (S : 0 <= (2 * p * y - a) ^ 2 / (4 * p))
    by (apply Rdiv_le_0_compat; [apply pow2_ge_0 | lra]).
  replace ((2 * p * y - a) ^ 2 / (4 * p)) with (p * y ^ 2 - y * a + 1 / (4 * p) * a ^ 2) in S
    by (field; lra).
  replace (kappa * (a ^ 2 / f)) with (kappa / f * a ^ 2) by (field; lra). nra.
Qed.

(** TH-LATENCY (second part): then it moves by [b], k whole samples of delay in all. *)
Lemma latency_second_part : forall kappa f k a b, 0 < f < 1 -> 0 <= k ->
  0 <= spare_mean kappa (k + f) -> 0 <= spare_square kappa (k + f) (latency_variance f) ->
  b ^ 2 / 2 + a * b + k * (a + b) ^ 2 + latency_memory kappa f * (a + b) ^ 2
  - latency_first kappa f * a ^ 2
  <= kappa * (b ^ 2 / (1 - f)).
Proof.
  intros kappa f k a b Hf Hk H1 H2. unfold spare_mean, spare_square, latency_variance in *.
  assert (k0 : 0 < kappa) by lra.
  set (p := latency_memory kappa f).
  assert (p0 : 0 < p).
  { unfold p, latency_memory. assert (0 < f * (1 - f) / (4 * kappa)); [| lra].
    apply Rdiv_lt_0_compat; nra. }
  set (n := 1 / 2 + k).
  set (A := kappa / f - 1 / (4 * p)). set (B := kappa / (1 - f)).
  assert (E : 4 * p * (f * (1 - f)) * (A * B - (n + p) * (A + B))
              = f / 2 * (4 * kappa * (kappa - 1 / 2 - (k + f)) - f * (1 - f))).
  { assert (Z : 4 * kappa * p - 2 * kappa * f - f * (1 - f) = 0)
      by (unfold p, latency_memory; field; lra).
    replace (4 * p * (f * (1 - f)) * (A * B - (n + p) * (A + B)))
      with (kappa * (4 * p * kappa - f) - (n + p) * (4 * p * kappa - f * (1 - f)))
      by (unfold A, B; field; repeat split; lra).
    replace (kappa - 1 / 2 - (k + f)) with (kappa - n - f) by (unfold n; ring).
    replace (kappa * (4 * p * kappa - f) - (n + p) * (4 * p * kappa - f * (1 - f)))
      with (f / 2 * (4 * kappa * (kappa - n - f) - f * (1 - f))
            + (4 * kappa * p - 2 * kappa * f - f * (1 - f)) * (kappa - (n + p) - f / 2)) by field.
    rewrite Z. ring. }
  assert (A0 : 0 < A).
  { unfold A. replace (kappa / f - 1 / (4 * p)) with ((4 * p * kappa - f) / (4 * p * f))
      by (field; split; lra).
    assert (F : f < 4 * p * kappa).
    { unfold p, latency_memory. replace (4 * (f / 2 + f * (1 - f) / (4 * kappa)) * kappa)
        with (2 * f * kappa + f * (1 - f)) by (field; lra). nra. }
    apply Rdiv_lt_0_compat; [lra | nra]. }
  assert (B0 : 0 < B) by (apply Rdiv_lt_0_compat; lra).
  assert (L0 : 0 < n + p) by (unfold n; lra).
  assert (Disc : 0 <= A * B - (n + p) * (A + B)).
  { apply Rmult_le_reg_l with (4 * p * (f * (1 - f))); [repeat apply Rmult_lt_0_compat; lra |].
    rewrite E, Rmult_0_r. apply Rmult_le_pos; lra. }
  assert (BL : 0 < B - (n + p)) by nra.
  assert (Goal : (n + p) * (a + b) ^ 2 <= A * a ^ 2 + B * b ^ 2).
  { apply Rmult_le_reg_l with (B - (n + p)); [exact BL |].
    assert (Sq : (B - (n + p)) * (A * a ^ 2 + B * b ^ 2 - (n + p) * (a + b) ^ 2)
      = ((B - (n + p)) * b - (n + p) * a) ^ 2 + (A * B - (n + p) * (A + B)) * a ^ 2) by ring.
    pose proof (pow2_ge_0 ((B - (n + p)) * b - (n + p) * a)).
    assert (0 <= (A * B - (n + p) * (A + B)) * a ^ 2)
      by (apply Rmult_le_pos; [exact Disc | apply pow2_ge_0]).
    lra. }
  unfold latency_first. fold p. unfold A, B, n in Goal.
  replace (kappa * (b ^ 2 / (1 - f))) with (kappa / (1 - f) * b ^ 2) by (field; lra). nra.
Qed.
