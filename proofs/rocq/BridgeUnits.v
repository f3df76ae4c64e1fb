(** * Bridge: each formula of the kernel is the definition that the theorems use.

    Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions BridgeTactics.
Open Scope R_scope.

(** [Loop::friction] *)
Definition kernel_loop_beta (b K T : R) : R :=
  (b / (K * T)).
Lemma bridge_loop_beta : forall b K T,
  kernel_loop_beta b K T = beta_of b K T.
Proof. unfold kernel_loop_beta. bridge. Qed.

(** [Loop::friction] *)
Definition kernel_loop_sigma (c K Delta : R) : R :=
  (c / (K * Delta)).
Lemma bridge_loop_sigma : forall c K Delta,
  kernel_loop_sigma c K Delta = sigma_of c K Delta.
Proof. unfold kernel_loop_sigma. bridge. Qed.

(** [Loop::dimensionless_speed] *)
Definition kernel_dimensionless_speed (v T Delta : R) : R :=
  ((v * T) / Delta).
Lemma bridge_dimensionless_speed : forall v T Delta,
  kernel_dimensionless_speed v T Delta = v * T / Delta.
Proof. unfold kernel_dimensionless_speed. bridge. Qed.

(** [Loop::dimensionless] *)
Definition kernel_loop_mu (m K T : R) : R :=
  (m / ((((1 * K) * T) * T) / 1)).
Lemma bridge_loop_mu : forall m K T,
  kernel_loop_mu m K T = mu_of m K T.
Proof. unfold kernel_loop_mu. intros; unfold mu_of; f_equal; field. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_viscous (b K T B : R) : R :=
  (b - (((K * T) * ((1 / 2) + 2)) + B)).
Lemma bridge_loop_viscous : forall b K T B,
  kernel_loop_viscous b K T B = viscous_si b K T 2 B.
Proof. unfold kernel_loop_viscous. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_coulomb (c K T Delta B F : R) : R :=
  (c - ((((K * Delta) / 2) + (B * (Delta / T))) + (F / 2))).
Lemma bridge_loop_coulomb : forall c K T Delta B F,
  kernel_loop_coulomb c K T Delta B F = coulomb_si c K T Delta B F.
Proof. unfold kernel_loop_coulomb. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_viscous_plain (b K T : R) : R :=
  (b - ((K * T) * ((1 / 2) + 0))).
Lemma bridge_loop_viscous_plain : forall b K T,
  kernel_loop_viscous_plain b K T = viscous_si b K T 0 0.
Proof. unfold kernel_loop_viscous_plain. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_coulomb_plain (c K Delta T : R) : R :=
  (c - ((K * Delta) / 2)).
Lemma bridge_loop_coulomb_plain : forall c K Delta T,
  kernel_loop_coulomb_plain c K Delta T = coulomb_si c K T Delta 0 0.
Proof. unfold kernel_loop_coulomb_plain. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_coulomb_smooth (c F : R) : R :=
  (c - (0 + (F / 2))).
Lemma bridge_loop_coulomb_smooth : forall c F,
  kernel_loop_coulomb_smooth c F = coulomb_si_smooth c F.
Proof. unfold kernel_loop_coulomb_smooth. bridge. Qed.

(** [Loop::dimensionless_criterion] *)
Definition kernel_dimensionless_viscous (b K T : R) : R :=
  ((b - ((K * T) * ((1 / 2) + 0))) / (K * T)).
Lemma bridge_dimensionless_viscous : forall b K T,
  K <> 0 -> T <> 0 -> kernel_dimensionless_viscous b K T = viscous_surplus (beta_of b K T) 0 0.
Proof. unfold kernel_dimensionless_viscous. bridge. Qed.

(** [Loop::dimensionless_criterion] *)
Definition kernel_dimensionless_coulomb (c K Delta : R) : R :=
  ((c - ((K * Delta) / 2)) / (K * Delta)).
Lemma bridge_dimensionless_coulomb : forall c K Delta,
  K <> 0 -> Delta <> 0 -> kernel_dimensionless_coulomb c K Delta = coulomb_surplus (sigma_of c K Delta) 0 0.
Proof. unfold kernel_dimensionless_coulomb. bridge. Qed.

(** [stiffness::viscous_limit] *)
Definition kernel_viscous_limit (b K T B : R) : R :=
  ((b - (((0 * T) * ((1 / 2) + 2)) + B)) / ((1 * T) * ((1 / 2) + 2))).
Lemma bridge_viscous_limit : forall b K T B,
  kernel_viscous_limit b K T B = viscous_limit b T 2 B.
Proof. unfold kernel_viscous_limit. bridge. Qed.

(** [stiffness::limit_at_speed] *)
Definition kernel_limit_at_speed (b c K T Delta v B F : R) : R :=
  ((((b - (((0 * T) * ((1 / 2) + 2)) + B)) * v) + (c - ((((0 * Delta) / 2) + (B * (Delta / T))) + (F / 2)))) / ((((1 * T) * ((1 / 2) + 2)) * v) + ((1 * Delta) / 2))).
Lemma bridge_limit_at_speed : forall b c K T Delta v B F,
  kernel_limit_at_speed b c K T Delta v B F = stiffness_limit b c T Delta v 2 B F.
Proof. unfold kernel_limit_at_speed. bridge. Qed.

(** [stiffness::limit_at_all_speeds] *)
Definition kernel_limit_at_all_speeds (b c K T Delta v B F : R) : R :=
  (Rmin ((b - (((0 * T) * ((1 / 2) + 2)) + B)) / ((1 * T) * ((1 / 2) + 2))) ((c - ((((0 * Delta) / 2) + (B * (Delta / T))) + (F / 2))) / ((1 * Delta) / 2))).
Lemma bridge_limit_at_all_speeds : forall b c K T Delta v B F,
  kernel_limit_at_all_speeds b c K T Delta v B F = Rmin (viscous_limit b T 2 B) (coulomb_limit c T Delta B F).
Proof. unfold kernel_limit_at_all_speeds. intros; apply f_equal2; bridge. Qed.

(** [stiffness::limit_at_speed] *)
Definition kernel_limit_at_speed_plain (b c K T Delta v : R) : R :=
  ((((b - ((0 * T) * ((1 / 2) + 0))) * v) + (c - ((0 * Delta) / 2))) / ((((1 * T) * ((1 / 2) + 0)) * v) + ((1 * Delta) / 2))).
Lemma bridge_limit_at_speed_plain : forall b c K T Delta v,
  kernel_limit_at_speed_plain b c K T Delta v = stiffness_limit b c T Delta v 0 0 0.
Proof. unfold kernel_limit_at_speed_plain. bridge. Qed.

(** [stiffness::coulomb_limit] *)
Definition kernel_coulomb_limit (c K T Delta B F : R) : R :=
  ((c - ((((0 * Delta) / 2) + (B * (Delta / T))) + (F / 2))) / ((1 * Delta) / 2)).
Lemma bridge_coulomb_limit : forall c K T Delta B F,
  kernel_coulomb_limit c K T Delta B F = coulomb_limit c T Delta B F.
Proof. unfold kernel_coulomb_limit. bridge. Qed.
