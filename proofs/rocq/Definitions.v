(** * Definitions: every formula that a theorem or the bridge speaks of, once.

    Dimensionless throughout, as in (3)-(7): position in encoder ticks, time in
    sampling periods, force in K*Delta, energy in K*Delta^2.  [x0], [x1] are the
    positions at the start and the end of a step, [d] its displacement, [dtau]
    the time it takes.  Numbers in round brackets are the paper's equations. *)

From Coq Require Import Reals Lra.
Open Scope R_scope.

(** ** The quantizer (15) and the held force (5) *)

(** The largest integer not above [x]: what the encoder counts. *)
Definition floor (x : R) : R := IZR (Int_part x).

(** The quantization error rho of (15). *)
Definition residue (x : R) : R := x - floor x.

(** The position a force law is given: the middle of the tick. *)
Definition measured (x : R) : R := floor x + 1 / 2.

(** The force held after a sample at [x] (5). *)
Definition held_force (x : R) : R := - measured x.

(** ** Stored energy (16), (17) *)

Definition linear_potential (x : R) : R := x ^ 2 / 2.

Definition quantization_potential (x : R) : R := (residue x - residue x ^ 2) / 2.

(** H_e of (16). *)
Definition quantized_potential (x : R) : R :=
  linear_potential x + quantization_potential x.

Definition kinetic (mu v : R) : R := mu * v ^ 2 / 2.

(** S, the storage that makes the criterion true. *)
Definition storage (mu x v : R) : R := kinetic mu v + linear_potential x.

(** H_T of (17). *)
Definition quantized_storage (mu x v : R) : R := kinetic mu v + quantized_potential x.

(** ** Generated energy (18)-(22) *)

(** D, the ticks crossed. *)
Definition ticks (x0 x1 : R) : R := floor x1 - floor x0.

(** (18) after integration: the work of a constant held force, plus what the
    counterpart with potential [p] gains. *)
Definition generated (held x0 x1 p0 p1 : R) : R := held * (x1 - x0) + p1 - p0.

(** Against the linear spring. *)
Definition generated_linear (x0 x1 : R) : R :=
  (x1 - x0) ^ 2 / 2 + (residue x0 - 1 / 2) * (x1 - x0).

(** E_gq of (20). *)
Definition quantization_effect (x0 x1 : R) : R :=
  (residue x0 - 1 / 2) * ticks x0 x1 - (residue x1 - residue x0) ^ 2 / 2.

(** Against the quantized spring, as in (19). *)
Definition generated_quantized (x0 x1 : R) : R :=
  (x1 - x0) ^ 2 / 2 + quantization_effect x0 x1.

(** The first bound of (21). *)
Definition bound_21 (D : R) : R := Rabs D / 2.

(** The right-hand side of (22). *)
Definition bound_22 (d : R) : R := d ^ 2 / 2 + Rabs d / 2.

(** The bound of TH-QUANT, with f = frac |d|. *)
Definition bound_quantized (d : R) : R :=
  bound_22 d + residue (Rabs d) * (1 - residue (Rabs d)) / 2.

(** ** Dissipated energy (23)-(26) *)

(** The integrand of (23). *)
Definition friction_power (beta sigma v : R) : R := beta * v ^ 2 + sigma * Rabs v.

(** The right-hand side of (26). *)
Definition dissipated_lower (beta sigma d dtau : R) : R :=
  beta * d ^ 2 / dtau + sigma * Rabs d.

(** Mean speed of a step. *)
Definition mean_speed (d dtau : R) : R := Rabs d / dtau.

(** ** The criterion (8), (27), with the effects of section 4

    [viscous] and [coulomb] are what friction has to spare.  [k] is the delay in
    whole samples, [B] the virtual damping in KT, [delta] the D/A step in
    K*Delta; without effects all three are 0. *)

Definition viscous_surplus (beta k B : R) : R := beta - 1 / 2 - k - B.

Definition coulomb_surplus (sigma delta B : R) : R := sigma - (1 + delta) / 2 - B.

(** (8) multiplied by the speed: passive when not negative. *)
Definition margin (viscous coulomb v : R) : R := viscous * v + coulomb.

(** (8) as printed, with 1/|v|: for moving devices. *)
Definition margin_8 (viscous coulomb v : R) : R := viscous + coulomb / Rabs v.

(** The left-hand side of (27). *)
Definition surplus (viscous coulomb d dtau : R) : R :=
  viscous * d ^ 2 / dtau + coulomb * Rabs d.

(** TH-JITTER: what an interval of any length has to spare.  [viscous_need] is
    1/2 + k + B, which is paid on d^2 whatever the length. *)
Definition jitter_surplus (beta viscous_need coulomb d dtau : R) : R :=
  (beta / dtau - viscous_need) * d ^ 2 + coulomb * Rabs d.

(** The critical line (9). *)
Definition critical_sigma (beta v : R) : R := 1 / 2 - v * (beta - 1 / 2).

(** ** TH-ACTIVE: the witness cycle between n - a and n + m *)

(** What the held force gives in a cycle. *)
Definition cycle_work (m a : R) : R := (m + 1) * (m + a).

(** What friction takes, one interval each way at constant speed. *)
Definition cycle_friction (m a beta sigma : R) : R :=
  2 * (beta * (m + a) ^ 2 + sigma * (m + a)).

Definition cycle_gain (m a beta sigma : R) : R :=
  cycle_work m a - cycle_friction m a beta sigma.

(** ** Extra storage at a sample (TH-DELAY, TH-DAMP)

    [d j] is the displacement over the interval that ended j - 1 samples ago. *)

Fixpoint sum_to (n : nat) (f : nat -> R) : R :=
  match n with
  | O => 0
  | S p => sum_to p f + f (S p)
  end.

(** Each step pays k * d^2 once: 1/2 k d^2 while it is current, the rest, with
    these weights, during the k steps after. *)
Definition delay_storage (k : nat) (d : nat -> R) : R :=
  sum_to k (fun j => (INR k - INR j + 1) * d j ^ 2 / 2).

Definition damping_storage (k : nat) (B : R) (d : nat -> R) : R :=
  B * sum_to (S k) (fun j => d j ^ 2) / 2.

(** ** Force laws (TH-LAW) and the D/A converter (TH-DAC) *)

(** The law of a wall clipped to forces in [lo, hi]: one-sided for lo = 0, saturated for
    lo = - hi. *)
Definition clipped (lo hi x : R) : R := Rmin (Rmax x lo) hi.
Definition clipped_below (lo x : R) : R := Rmax x lo.

(** The potential of a clipped law with force [p] at [x]. *)
Definition law_potential_of (x p : R) : R := x * p - p ^ 2 / 2.

(** A force rounded to the nearest multiple of the D/A step. *)
Definition rounded_force (F delta : R) : R := delta * floor (F / delta + 1 / 2).

(** ** The potential of a clipped law over the quantizer's ticks (16)

    [beyond]: what the part of the law that is beyond a limit would store from 0 to the tick
    [tick] and [rho] of the next one; tick j is beyond when j + 1/2 is. *)

Definition first_beyond (limit : R) : R := Rmax (- floor (1 / 2 - limit)) 0.

Definition beyond (limit tick rho : R) : R :=
  Rmax (tick - first_beyond limit) 0
    * (first_beyond limit - limit + Rmax (tick - first_beyond limit) 0 / 2)
  + Rmax (tick + 1 / 2 - limit) 0 * rho.

(** From the other side tick n is tick - 1 - n, and what is left of it is 1 - rho. *)
Definition quantized_clipped_potential (lo hi x : R) : R :=
  quantized_potential x - beyond hi (floor x) (residue x)
  - beyond (- lo) (- (floor x + 1)) (1 - residue x).

(** What switching a wall with potential [p] adds to what is stored (ERR-IV-C). *)
Definition switching_energy (was_on is_on : bool) (p : R) : R :=
  (if is_on then p else 0) - (if was_on then p else 0).

(** ** The controller: the control law as a program computes it

    From two successive measured positions, both late by the same delay: damp, cut off outside
    a wall on one side, round to the D/A step, saturate; in that order. *)

(** A wall on one side pushes only when the measured position is inside. *)
Definition gated (one_sided : bool) (q F : R) : R :=
  if one_sided then (if Rlt_dec q 0 then 0 else F) else F.

Definition stepped (step : option R) (u : R) : R :=
  match step with Some delta => rounded_force u delta | None => u end.

Definition limited (limit : option R) (u : R) : R :=
  match limit with Some L => clipped (- L) L u | None => u end.

(** The held force. *)
Definition controller (one_sided : bool) (B : R) (step limit : option R) (q q' : R) : R :=
  limited limit (stepped step (- gated one_sided q (q + B * (q - q')))).

(** The force law that it softens or stiffens from: what is left without damping and step. *)
Definition controller_law (one_sided : bool) (limit : option R) (x : R) : R :=
  match one_sided, limit with
  | false, None => x
  | true, None => clipped_below 0 x
  | false, Some L => clipped (- L) L x
  | true, Some L => clipped 0 L x
  end.

Definition controller_potential (one_sided : bool) (limit : option R) (x : R) : R :=
  law_potential_of x (controller_law one_sided limit x).

(** ** In SI units: (1), (2), (7), (11) *)

Definition beta_of (b K T : R) : R := b / (K * T).
Definition sigma_of (c K Delta : R) : R := c / (K * Delta).
Definition mu_of (m K T : R) : R := m / (K * T ^ 2).

(** What viscous friction has to spare: k samples of delay, virtual damping [B]. *)
Definition viscous_si (b K T k B : R) : R := b - K * T * (1 / 2 + k) - B.

(** What Coulomb friction has to spare: virtual damping [B], force step [F]. *)
Definition coulomb_si (c K T Delta B F : R) : R :=
  c - K * Delta / 2 - B * Delta / T - F / 2.

(** The same without an encoder (TH-SMOOTH). *)
Definition coulomb_si_smooth (c F : R) : R := c - F / 2.

(** ** Limits *)

(** V^2 of TH-START: the square of the speed that an unforced motion never passes. *)
Definition start_speed_squared (mu x v : R) : R := v ^ 2 + x ^ 2 / mu.

(** The same with the extra storage at the start of a controller that remembers a motion. *)
Definition start_speed_squared_with_memory (mu x v extra : R) : R :=
  start_speed_squared mu x v + 2 * extra / mu.

(** The margin at V >= 0 of a criterion with viscous < 0 < coulomb has the sign of this. *)
Definition margin_of_squares (viscous coulomb V2 : R) : R := coulomb ^ 2 - viscous ^ 2 * V2.

(** TH-REGION: the speed at which the criterion changes sign. *)
Definition critical_speed (viscous coulomb : R) : R := - coulomb / viscous.

(** TH-STIFF, from (11): the stiffest wall at speed [v]. *)
Definition stiffness_limit (b c T Delta v k B F : R) : R :=
  ((b - B) * v + (c - B * Delta / T - F / 2)) / (T * (1 / 2 + k) * v + Delta / 2).

(** TH-STIFF: the two limits whose smaller is the stiffest wall at every speed. *)
Definition viscous_limit (b T k B : R) : R := (b - B) / (T * (1 / 2 + k)).
Definition coulomb_limit (c T Delta B F : R) : R := (c - B * Delta / T - F / 2) / (Delta / 2).

(** TH-STIFF: the border values of the other parameters, the rest as it is. *)
Definition longest_period (b K k B : R) : R := (b - B) / (K * (1 / 2 + k)).
Definition shortest_period (c K Delta B F : R) : R := B * Delta / (c - K * Delta / 2 - F / 2).
Definition coarsest_resolution (c K T B F : R) : R := (c - F / 2) / (K / 2 + B / T).

(** The period with the largest product of period and margin at speed [v]. *)
Definition best_period (b c K Delta v k B F : R) : R :=
  (c - K * Delta / 2 - F / 2 + (b - B) * v) / (2 * (K * (1 / 2 + k) * v)).

(** ** Regions (TH-REGION): sets of speeds v > 0 at which the criterion holds *)

Definition holds_at_all (viscous coulomb : R) : Prop :=
  forall v, 0 < v -> 0 <= margin viscous coulomb v.

Definition holds_up_to (viscous coulomb V : R) : Prop :=
  forall v, 0 < v <= V -> 0 <= margin viscous coulomb v.

(** All speeds. *)
Definition globally_stable : R -> R -> Prop := holds_at_all.

(** Those up to a critical speed. *)
Definition locally_stable (viscous coulomb : R) : Prop :=
  0 < critical_speed viscous coulomb /\
  forall v, 0 < v -> (0 <= margin viscous coulomb v <-> v <= critical_speed viscous coulomb).

(** Those from a critical speed on. *)
Definition limit_cycles (viscous coulomb : R) : Prop :=
  0 < critical_speed viscous coulomb /\
  forall v, 0 < v -> (0 <= margin viscous coulomb v <-> critical_speed viscous coulomb <= v).

(** None. *)
Definition unstable (viscous coulomb : R) : Prop :=
  forall v, 0 < v -> margin viscous coulomb v < 0.
