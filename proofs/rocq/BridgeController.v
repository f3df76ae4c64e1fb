(** * Bridge: each formula of the kernel is the definition that the theorems use.

    Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions BridgeTactics ControllerTactics.
Open Scope R_scope.

(** [Controller::held_force] *)
Definition kernel_held_plain_0 (x0 : R) : R :=
  (- (1 * x0)).
Lemma bridge_held_plain_0 : forall x0,
  kernel_held_plain_0 x0 = controller false 0 None None x0 x0.
Proof. unfold kernel_held_plain_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_plain_1 (x0 x1 : R) : R :=
  (- (1 * x1)).
Lemma bridge_held_plain_1 : forall x0 x1,
  kernel_held_plain_1 x0 x1 = controller false 0 None None x1 x1.
Proof. unfold kernel_held_plain_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_plain_2 (x0 x1 x2 : R) : R :=
  (- (1 * x2)).
Lemma bridge_held_plain_2 : forall x0 x1 x2,
  kernel_held_plain_2 x0 x1 x2 = controller false 0 None None x2 x2.
Proof. unfold kernel_held_plain_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_plain_3 (x0 x1 x2 x3 : R) : R :=
  (- (1 * x3)).
Lemma bridge_held_plain_3 : forall x0 x1 x2 x3,
  kernel_held_plain_3 x0 x1 x2 x3 = controller false 0 None None x3 x3.
Proof. unfold kernel_held_plain_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_0 (x0 : R) : R :=
  (- (1 * ((floor x0) + (1 / 2)))).
Lemma bridge_held_encoder_0 : forall x0,
  kernel_held_encoder_0 x0 = controller false 0 None None (measured x0) (measured x0).
Proof. unfold kernel_held_encoder_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_1 (x0 x1 : R) : R :=
  (- (1 * ((floor x1) + (1 / 2)))).
Lemma bridge_held_encoder_1 : forall x0 x1,
  kernel_held_encoder_1 x0 x1 = controller false 0 None None (measured x1) (measured x1).
Proof. unfold kernel_held_encoder_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_2 (x0 x1 x2 : R) : R :=
  (- (1 * ((floor x2) + (1 / 2)))).
Lemma bridge_held_encoder_2 : forall x0 x1 x2,
  kernel_held_encoder_2 x0 x1 x2 = controller false 0 None None (measured x2) (measured x2).
Proof. unfold kernel_held_encoder_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_3 (x0 x1 x2 x3 : R) : R :=
  (- (1 * ((floor x3) + (1 / 2)))).
Lemma bridge_held_encoder_3 : forall x0 x1 x2 x3,
  kernel_held_encoder_3 x0 x1 x2 x3 = controller false 0 None None (measured x3) (measured x3).
Proof. unfold kernel_held_encoder_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_0 (x0 : R) : R :=
  (- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))).
Lemma bridge_held_one_sided_0 : forall x0,
  kernel_held_one_sided_0 x0 = controller true 0 None None x0 x0.
Proof. unfold kernel_held_one_sided_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_1 (x0 x1 : R) : R :=
  (- ((1 * x1) * ((floor (Rmin (Rmax x1 (- 1)) 0)) + 1))).
Lemma bridge_held_one_sided_1 : forall x0 x1,
  kernel_held_one_sided_1 x0 x1 = controller true 0 None None x1 x1.
Proof. unfold kernel_held_one_sided_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_2 (x0 x1 x2 : R) : R :=
  (- ((1 * x2) * ((floor (Rmin (Rmax x2 (- 1)) 0)) + 1))).
Lemma bridge_held_one_sided_2 : forall x0 x1 x2,
  kernel_held_one_sided_2 x0 x1 x2 = controller true 0 None None x2 x2.
Proof. unfold kernel_held_one_sided_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_3 (x0 x1 x2 x3 : R) : R :=
  (- ((1 * x3) * ((floor (Rmin (Rmax x3 (- 1)) 0)) + 1))).
Lemma bridge_held_one_sided_3 : forall x0 x1 x2 x3,
  kernel_held_one_sided_3 x0 x1 x2 x3 = controller true 0 None None x3 x3.
Proof. unfold kernel_held_one_sided_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_0 (x0 : R) : R :=
  (- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_held_encoder_one_sided_0 : forall x0,
  kernel_held_encoder_one_sided_0 x0 = controller true 0 None None (measured x0) (measured x0).
Proof. unfold kernel_held_encoder_one_sided_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_1 (x0 x1 : R) : R :=
  (- ((1 * ((floor x1) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x1) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_held_encoder_one_sided_1 : forall x0 x1,
  kernel_held_encoder_one_sided_1 x0 x1 = controller true 0 None None (measured x1) (measured x1).
Proof. unfold kernel_held_encoder_one_sided_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_2 (x0 x1 x2 : R) : R :=
  (- ((1 * ((floor x2) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x2) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_held_encoder_one_sided_2 : forall x0 x1 x2,
  kernel_held_encoder_one_sided_2 x0 x1 x2 = controller true 0 None None (measured x2) (measured x2).
Proof. unfold kernel_held_encoder_one_sided_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_3 (x0 x1 x2 x3 : R) : R :=
  (- ((1 * ((floor x3) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x3) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_held_encoder_one_sided_3 : forall x0 x1 x2 x3,
  kernel_held_encoder_one_sided_3 x0 x1 x2 x3 = controller true 0 None None (measured x3) (measured x3).
Proof. unfold kernel_held_encoder_one_sided_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_0 (x0 x1 B : R) : R :=
  (- ((1 * x0) + ((- B) * (x1 - x0)))).
Lemma bridge_held_damped_0 : forall x0 x1 B,
  kernel_held_damped_0 x0 x1 B = controller false B None None x0 x1.
Proof. unfold kernel_held_damped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_1 (x0 x1 x2 B : R) : R :=
  (- ((1 * x1) + ((- B) * (x2 - x1)))).
Lemma bridge_held_damped_1 : forall x0 x1 x2 B,
  kernel_held_damped_1 x0 x1 x2 B = controller false B None None x1 x2.
Proof. unfold kernel_held_damped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_2 (x0 x1 x2 x3 B : R) : R :=
  (- ((1 * x2) + ((- B) * (x3 - x2)))).
Lemma bridge_held_damped_2 : forall x0 x1 x2 x3 B,
  kernel_held_damped_2 x0 x1 x2 x3 B = controller false B None None x2 x3.
Proof. unfold kernel_held_damped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_3 (x0 x1 x2 x3 x4 B : R) : R :=
  (- ((1 * x3) + ((- B) * (x4 - x3)))).
Lemma bridge_held_damped_3 : forall x0 x1 x2 x3 x4 B,
  kernel_held_damped_3 x0 x1 x2 x3 x4 B = controller false B None None x3 x4.
Proof. unfold kernel_held_damped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_0 (x0 x1 B : R) : R :=
  (- ((1 * ((floor x0) + (1 / 2))) + ((- B) * (((floor x1) + (1 / 2)) - ((floor x0) + (1 / 2)))))).
Lemma bridge_held_encoder_damped_0 : forall x0 x1 B,
  kernel_held_encoder_damped_0 x0 x1 B = controller false B None None (measured x0) (measured x1).
Proof. unfold kernel_held_encoder_damped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_1 (x0 x1 x2 B : R) : R :=
  (- ((1 * ((floor x1) + (1 / 2))) + ((- B) * (((floor x2) + (1 / 2)) - ((floor x1) + (1 / 2)))))).
Lemma bridge_held_encoder_damped_1 : forall x0 x1 x2 B,
  kernel_held_encoder_damped_1 x0 x1 x2 B = controller false B None None (measured x1) (measured x2).
Proof. unfold kernel_held_encoder_damped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_2 (x0 x1 x2 x3 B : R) : R :=
  (- ((1 * ((floor x2) + (1 / 2))) + ((- B) * (((floor x3) + (1 / 2)) - ((floor x2) + (1 / 2)))))).
Lemma bridge_held_encoder_damped_2 : forall x0 x1 x2 x3 B,
  kernel_held_encoder_damped_2 x0 x1 x2 x3 B = controller false B None None (measured x2) (measured x3).
Proof. unfold kernel_held_encoder_damped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_3 (x0 x1 x2 x3 x4 B : R) : R :=
  (- ((1 * ((floor x3) + (1 / 2))) + ((- B) * (((floor x4) + (1 / 2)) - ((floor x3) + (1 / 2)))))).
Lemma bridge_held_encoder_damped_3 : forall x0 x1 x2 x3 x4 B,
  kernel_held_encoder_damped_3 x0 x1 x2 x3 x4 B = controller false B None None (measured x3) (measured x4).
Proof. unfold kernel_held_encoder_damped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_0 (x0 x1 B : R) : R :=
  (- (((1 * x0) + ((- B) * (x1 - x0))) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))).
Lemma bridge_held_one_sided_damped_0 : forall x0 x1 B,
  kernel_held_one_sided_damped_0 x0 x1 B = controller true B None None x0 x1.
Proof. unfold kernel_held_one_sided_damped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_1 (x0 x1 x2 B : R) : R :=
  (- (((1 * x1) + ((- B) * (x2 - x1))) * ((floor (Rmin (Rmax x1 (- 1)) 0)) + 1))).
Lemma bridge_held_one_sided_damped_1 : forall x0 x1 x2 B,
  kernel_held_one_sided_damped_1 x0 x1 x2 B = controller true B None None x1 x2.
Proof. unfold kernel_held_one_sided_damped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_2 (x0 x1 x2 x3 B : R) : R :=
  (- (((1 * x2) + ((- B) * (x3 - x2))) * ((floor (Rmin (Rmax x2 (- 1)) 0)) + 1))).
Lemma bridge_held_one_sided_damped_2 : forall x0 x1 x2 x3 B,
  kernel_held_one_sided_damped_2 x0 x1 x2 x3 B = controller true B None None x2 x3.
Proof. unfold kernel_held_one_sided_damped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_3 (x0 x1 x2 x3 x4 B : R) : R :=
  (- (((1 * x3) + ((- B) * (x4 - x3))) * ((floor (Rmin (Rmax x3 (- 1)) 0)) + 1))).
Lemma bridge_held_one_sided_damped_3 : forall x0 x1 x2 x3 x4 B,
  kernel_held_one_sided_damped_3 x0 x1 x2 x3 x4 B = controller true B None None x3 x4.
Proof. unfold kernel_held_one_sided_damped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_0 (x0 x1 B : R) : R :=
  (- (((1 * ((floor x0) + (1 / 2))) + ((- B) * (((floor x1) + (1 / 2)) - ((floor x0) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_held_encoder_one_sided_damped_0 : forall x0 x1 B,
  kernel_held_encoder_one_sided_damped_0 x0 x1 B = controller true B None None (measured x0) (measured x1).
Proof. unfold kernel_held_encoder_one_sided_damped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_1 (x0 x1 x2 B : R) : R :=
  (- (((1 * ((floor x1) + (1 / 2))) + ((- B) * (((floor x2) + (1 / 2)) - ((floor x1) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x1) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_held_encoder_one_sided_damped_1 : forall x0 x1 x2 B,
  kernel_held_encoder_one_sided_damped_1 x0 x1 x2 B = controller true B None None (measured x1) (measured x2).
Proof. unfold kernel_held_encoder_one_sided_damped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_2 (x0 x1 x2 x3 B : R) : R :=
  (- (((1 * ((floor x2) + (1 / 2))) + ((- B) * (((floor x3) + (1 / 2)) - ((floor x2) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x2) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_held_encoder_one_sided_damped_2 : forall x0 x1 x2 x3 B,
  kernel_held_encoder_one_sided_damped_2 x0 x1 x2 x3 B = controller true B None None (measured x2) (measured x3).
Proof. unfold kernel_held_encoder_one_sided_damped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_3 (x0 x1 x2 x3 x4 B : R) : R :=
  (- (((1 * ((floor x3) + (1 / 2))) + ((- B) * (((floor x4) + (1 / 2)) - ((floor x3) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x3) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_held_encoder_one_sided_damped_3 : forall x0 x1 x2 x3 x4 B,
  kernel_held_encoder_one_sided_damped_3 x0 x1 x2 x3 x4 B = controller true B None None (measured x3) (measured x4).
Proof. unfold kernel_held_encoder_one_sided_damped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_stepped_0 (x0 delta : R) : R :=
  (((floor ((((- (1 * x0)) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_stepped_0 : forall x0 delta,
  kernel_held_stepped_0 x0 delta = controller false 0 (Some delta) None x0 x0.
Proof. unfold kernel_held_stepped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_stepped_1 (x0 x1 delta : R) : R :=
  (((floor ((((- (1 * x1)) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_stepped_1 : forall x0 x1 delta,
  kernel_held_stepped_1 x0 x1 delta = controller false 0 (Some delta) None x1 x1.
Proof. unfold kernel_held_stepped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_stepped_2 (x0 x1 x2 delta : R) : R :=
  (((floor ((((- (1 * x2)) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_stepped_2 : forall x0 x1 x2 delta,
  kernel_held_stepped_2 x0 x1 x2 delta = controller false 0 (Some delta) None x2 x2.
Proof. unfold kernel_held_stepped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_stepped_3 (x0 x1 x2 x3 delta : R) : R :=
  (((floor ((((- (1 * x3)) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_stepped_3 : forall x0 x1 x2 x3 delta,
  kernel_held_stepped_3 x0 x1 x2 x3 delta = controller false 0 (Some delta) None x3 x3.
Proof. unfold kernel_held_stepped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_stepped_0 (x0 delta : R) : R :=
  (((floor ((((- (1 * ((floor x0) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_stepped_0 : forall x0 delta,
  kernel_held_encoder_stepped_0 x0 delta = controller false 0 (Some delta) None (measured x0) (measured x0).
Proof. unfold kernel_held_encoder_stepped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_stepped_1 (x0 x1 delta : R) : R :=
  (((floor ((((- (1 * ((floor x1) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_stepped_1 : forall x0 x1 delta,
  kernel_held_encoder_stepped_1 x0 x1 delta = controller false 0 (Some delta) None (measured x1) (measured x1).
Proof. unfold kernel_held_encoder_stepped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_stepped_2 (x0 x1 x2 delta : R) : R :=
  (((floor ((((- (1 * ((floor x2) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_stepped_2 : forall x0 x1 x2 delta,
  kernel_held_encoder_stepped_2 x0 x1 x2 delta = controller false 0 (Some delta) None (measured x2) (measured x2).
Proof. unfold kernel_held_encoder_stepped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_stepped_3 (x0 x1 x2 x3 delta : R) : R :=
  (((floor ((((- (1 * ((floor x3) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_stepped_3 : forall x0 x1 x2 x3 delta,
  kernel_held_encoder_stepped_3 x0 x1 x2 x3 delta = controller false 0 (Some delta) None (measured x3) (measured x3).
Proof. unfold kernel_held_encoder_stepped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_stepped_0 (x0 delta : R) : R :=
  (((floor ((((- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_one_sided_stepped_0 : forall x0 delta,
  kernel_held_one_sided_stepped_0 x0 delta = controller true 0 (Some delta) None x0 x0.
Proof. unfold kernel_held_one_sided_stepped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_stepped_1 (x0 x1 delta : R) : R :=
  (((floor ((((- ((1 * x1) * ((floor (Rmin (Rmax x1 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_one_sided_stepped_1 : forall x0 x1 delta,
  kernel_held_one_sided_stepped_1 x0 x1 delta = controller true 0 (Some delta) None x1 x1.
Proof. unfold kernel_held_one_sided_stepped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_stepped_2 (x0 x1 x2 delta : R) : R :=
  (((floor ((((- ((1 * x2) * ((floor (Rmin (Rmax x2 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_one_sided_stepped_2 : forall x0 x1 x2 delta,
  kernel_held_one_sided_stepped_2 x0 x1 x2 delta = controller true 0 (Some delta) None x2 x2.
Proof. unfold kernel_held_one_sided_stepped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_stepped_3 (x0 x1 x2 x3 delta : R) : R :=
  (((floor ((((- ((1 * x3) * ((floor (Rmin (Rmax x3 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_one_sided_stepped_3 : forall x0 x1 x2 x3 delta,
  kernel_held_one_sided_stepped_3 x0 x1 x2 x3 delta = controller true 0 (Some delta) None x3 x3.
Proof. unfold kernel_held_one_sided_stepped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_stepped_0 (x0 delta : R) : R :=
  (((floor ((((- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_one_sided_stepped_0 : forall x0 delta,
  kernel_held_encoder_one_sided_stepped_0 x0 delta = controller true 0 (Some delta) None (measured x0) (measured x0).
Proof. unfold kernel_held_encoder_one_sided_stepped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_stepped_1 (x0 x1 delta : R) : R :=
  (((floor ((((- ((1 * ((floor x1) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x1) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_one_sided_stepped_1 : forall x0 x1 delta,
  kernel_held_encoder_one_sided_stepped_1 x0 x1 delta = controller true 0 (Some delta) None (measured x1) (measured x1).
Proof. unfold kernel_held_encoder_one_sided_stepped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_stepped_2 (x0 x1 x2 delta : R) : R :=
  (((floor ((((- ((1 * ((floor x2) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x2) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_one_sided_stepped_2 : forall x0 x1 x2 delta,
  kernel_held_encoder_one_sided_stepped_2 x0 x1 x2 delta = controller true 0 (Some delta) None (measured x2) (measured x2).
Proof. unfold kernel_held_encoder_one_sided_stepped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_stepped_3 (x0 x1 x2 x3 delta : R) : R :=
  (((floor ((((- ((1 * ((floor x3) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x3) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_one_sided_stepped_3 : forall x0 x1 x2 x3 delta,
  kernel_held_encoder_one_sided_stepped_3 x0 x1 x2 x3 delta = controller true 0 (Some delta) None (measured x3) (measured x3).
Proof. unfold kernel_held_encoder_one_sided_stepped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_stepped_0 (x0 x1 B delta : R) : R :=
  (((floor ((((- ((1 * x0) + ((- B) * (x1 - x0)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_damped_stepped_0 : forall x0 x1 B delta,
  kernel_held_damped_stepped_0 x0 x1 B delta = controller false B (Some delta) None x0 x1.
Proof. unfold kernel_held_damped_stepped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_stepped_1 (x0 x1 x2 B delta : R) : R :=
  (((floor ((((- ((1 * x1) + ((- B) * (x2 - x1)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_damped_stepped_1 : forall x0 x1 x2 B delta,
  kernel_held_damped_stepped_1 x0 x1 x2 B delta = controller false B (Some delta) None x1 x2.
Proof. unfold kernel_held_damped_stepped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_stepped_2 (x0 x1 x2 x3 B delta : R) : R :=
  (((floor ((((- ((1 * x2) + ((- B) * (x3 - x2)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_damped_stepped_2 : forall x0 x1 x2 x3 B delta,
  kernel_held_damped_stepped_2 x0 x1 x2 x3 B delta = controller false B (Some delta) None x2 x3.
Proof. unfold kernel_held_damped_stepped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_stepped_3 (x0 x1 x2 x3 x4 B delta : R) : R :=
  (((floor ((((- ((1 * x3) + ((- B) * (x4 - x3)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_damped_stepped_3 : forall x0 x1 x2 x3 x4 B delta,
  kernel_held_damped_stepped_3 x0 x1 x2 x3 x4 B delta = controller false B (Some delta) None x3 x4.
Proof. unfold kernel_held_damped_stepped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_stepped_0 (x0 x1 B delta : R) : R :=
  (((floor ((((- ((1 * ((floor x0) + (1 / 2))) + ((- B) * (((floor x1) + (1 / 2)) - ((floor x0) + (1 / 2)))))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_damped_stepped_0 : forall x0 x1 B delta,
  kernel_held_encoder_damped_stepped_0 x0 x1 B delta = controller false B (Some delta) None (measured x0) (measured x1).
Proof. unfold kernel_held_encoder_damped_stepped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_stepped_1 (x0 x1 x2 B delta : R) : R :=
  (((floor ((((- ((1 * ((floor x1) + (1 / 2))) + ((- B) * (((floor x2) + (1 / 2)) - ((floor x1) + (1 / 2)))))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_damped_stepped_1 : forall x0 x1 x2 B delta,
  kernel_held_encoder_damped_stepped_1 x0 x1 x2 B delta = controller false B (Some delta) None (measured x1) (measured x2).
Proof. unfold kernel_held_encoder_damped_stepped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_stepped_2 (x0 x1 x2 x3 B delta : R) : R :=
  (((floor ((((- ((1 * ((floor x2) + (1 / 2))) + ((- B) * (((floor x3) + (1 / 2)) - ((floor x2) + (1 / 2)))))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_damped_stepped_2 : forall x0 x1 x2 x3 B delta,
  kernel_held_encoder_damped_stepped_2 x0 x1 x2 x3 B delta = controller false B (Some delta) None (measured x2) (measured x3).
Proof. unfold kernel_held_encoder_damped_stepped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_stepped_3 (x0 x1 x2 x3 x4 B delta : R) : R :=
  (((floor ((((- ((1 * ((floor x3) + (1 / 2))) + ((- B) * (((floor x4) + (1 / 2)) - ((floor x3) + (1 / 2)))))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_damped_stepped_3 : forall x0 x1 x2 x3 x4 B delta,
  kernel_held_encoder_damped_stepped_3 x0 x1 x2 x3 x4 B delta = controller false B (Some delta) None (measured x3) (measured x4).
Proof. unfold kernel_held_encoder_damped_stepped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_stepped_0 (x0 x1 B delta : R) : R :=
  (((floor ((((- (((1 * x0) + ((- B) * (x1 - x0))) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_one_sided_damped_stepped_0 : forall x0 x1 B delta,
  kernel_held_one_sided_damped_stepped_0 x0 x1 B delta = controller true B (Some delta) None x0 x1.
Proof. unfold kernel_held_one_sided_damped_stepped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_stepped_1 (x0 x1 x2 B delta : R) : R :=
  (((floor ((((- (((1 * x1) + ((- B) * (x2 - x1))) * ((floor (Rmin (Rmax x1 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_one_sided_damped_stepped_1 : forall x0 x1 x2 B delta,
  kernel_held_one_sided_damped_stepped_1 x0 x1 x2 B delta = controller true B (Some delta) None x1 x2.
Proof. unfold kernel_held_one_sided_damped_stepped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_stepped_2 (x0 x1 x2 x3 B delta : R) : R :=
  (((floor ((((- (((1 * x2) + ((- B) * (x3 - x2))) * ((floor (Rmin (Rmax x2 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_one_sided_damped_stepped_2 : forall x0 x1 x2 x3 B delta,
  kernel_held_one_sided_damped_stepped_2 x0 x1 x2 x3 B delta = controller true B (Some delta) None x2 x3.
Proof. unfold kernel_held_one_sided_damped_stepped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_stepped_3 (x0 x1 x2 x3 x4 B delta : R) : R :=
  (((floor ((((- (((1 * x3) + ((- B) * (x4 - x3))) * ((floor (Rmin (Rmax x3 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_one_sided_damped_stepped_3 : forall x0 x1 x2 x3 x4 B delta,
  kernel_held_one_sided_damped_stepped_3 x0 x1 x2 x3 x4 B delta = controller true B (Some delta) None x3 x4.
Proof. unfold kernel_held_one_sided_damped_stepped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_stepped_0 (x0 x1 B delta : R) : R :=
  (((floor ((((- (((1 * ((floor x0) + (1 / 2))) + ((- B) * (((floor x1) + (1 / 2)) - ((floor x0) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_one_sided_damped_stepped_0 : forall x0 x1 B delta,
  kernel_held_encoder_one_sided_damped_stepped_0 x0 x1 B delta = controller true B (Some delta) None (measured x0) (measured x1).
Proof. unfold kernel_held_encoder_one_sided_damped_stepped_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_stepped_1 (x0 x1 x2 B delta : R) : R :=
  (((floor ((((- (((1 * ((floor x1) + (1 / 2))) + ((- B) * (((floor x2) + (1 / 2)) - ((floor x1) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x1) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_one_sided_damped_stepped_1 : forall x0 x1 x2 B delta,
  kernel_held_encoder_one_sided_damped_stepped_1 x0 x1 x2 B delta = controller true B (Some delta) None (measured x1) (measured x2).
Proof. unfold kernel_held_encoder_one_sided_damped_stepped_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_stepped_2 (x0 x1 x2 x3 B delta : R) : R :=
  (((floor ((((- (((1 * ((floor x2) + (1 / 2))) + ((- B) * (((floor x3) + (1 / 2)) - ((floor x2) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x2) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_one_sided_damped_stepped_2 : forall x0 x1 x2 x3 B delta,
  kernel_held_encoder_one_sided_damped_stepped_2 x0 x1 x2 x3 B delta = controller true B (Some delta) None (measured x2) (measured x3).
Proof. unfold kernel_held_encoder_one_sided_damped_stepped_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_stepped_3 (x0 x1 x2 x3 x4 B delta : R) : R :=
  (((floor ((((- (((1 * ((floor x3) + (1 / 2))) + ((- B) * (((floor x4) + (1 / 2)) - ((floor x3) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x3) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_held_encoder_one_sided_damped_stepped_3 : forall x0 x1 x2 x3 x4 B delta,
  kernel_held_encoder_one_sided_damped_stepped_3 x0 x1 x2 x3 x4 B delta = controller true B (Some delta) None (measured x3) (measured x4).
Proof. unfold kernel_held_encoder_one_sided_damped_stepped_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_limited_0 (x0 L : R) : R :=
  (Rmax (Rmin (- (1 * x0)) L) (- L)).
Lemma bridge_held_limited_0 : forall x0 L,
  0 <= L -> kernel_held_limited_0 x0 L = controller false 0 None (Some L) x0 x0.
Proof. unfold kernel_held_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_limited_1 (x0 x1 L : R) : R :=
  (Rmax (Rmin (- (1 * x1)) L) (- L)).
Lemma bridge_held_limited_1 : forall x0 x1 L,
  0 <= L -> kernel_held_limited_1 x0 x1 L = controller false 0 None (Some L) x1 x1.
Proof. unfold kernel_held_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_limited_2 (x0 x1 x2 L : R) : R :=
  (Rmax (Rmin (- (1 * x2)) L) (- L)).
Lemma bridge_held_limited_2 : forall x0 x1 x2 L,
  0 <= L -> kernel_held_limited_2 x0 x1 x2 L = controller false 0 None (Some L) x2 x2.
Proof. unfold kernel_held_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_limited_3 (x0 x1 x2 x3 L : R) : R :=
  (Rmax (Rmin (- (1 * x3)) L) (- L)).
Lemma bridge_held_limited_3 : forall x0 x1 x2 x3 L,
  0 <= L -> kernel_held_limited_3 x0 x1 x2 x3 L = controller false 0 None (Some L) x3 x3.
Proof. unfold kernel_held_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_limited_0 (x0 L : R) : R :=
  (Rmax (Rmin (- (1 * ((floor x0) + (1 / 2)))) L) (- L)).
Lemma bridge_held_encoder_limited_0 : forall x0 L,
  0 <= L -> kernel_held_encoder_limited_0 x0 L = controller false 0 None (Some L) (measured x0) (measured x0).
Proof. unfold kernel_held_encoder_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_limited_1 (x0 x1 L : R) : R :=
  (Rmax (Rmin (- (1 * ((floor x1) + (1 / 2)))) L) (- L)).
Lemma bridge_held_encoder_limited_1 : forall x0 x1 L,
  0 <= L -> kernel_held_encoder_limited_1 x0 x1 L = controller false 0 None (Some L) (measured x1) (measured x1).
Proof. unfold kernel_held_encoder_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_limited_2 (x0 x1 x2 L : R) : R :=
  (Rmax (Rmin (- (1 * ((floor x2) + (1 / 2)))) L) (- L)).
Lemma bridge_held_encoder_limited_2 : forall x0 x1 x2 L,
  0 <= L -> kernel_held_encoder_limited_2 x0 x1 x2 L = controller false 0 None (Some L) (measured x2) (measured x2).
Proof. unfold kernel_held_encoder_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_limited_3 (x0 x1 x2 x3 L : R) : R :=
  (Rmax (Rmin (- (1 * ((floor x3) + (1 / 2)))) L) (- L)).
Lemma bridge_held_encoder_limited_3 : forall x0 x1 x2 x3 L,
  0 <= L -> kernel_held_encoder_limited_3 x0 x1 x2 x3 L = controller false 0 None (Some L) (measured x3) (measured x3).
Proof. unfold kernel_held_encoder_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_limited_0 (x0 L : R) : R :=
  (Rmax (Rmin (- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_one_sided_limited_0 : forall x0 L,
  0 <= L -> kernel_held_one_sided_limited_0 x0 L = controller true 0 None (Some L) x0 x0.
Proof. unfold kernel_held_one_sided_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_limited_1 (x0 x1 L : R) : R :=
  (Rmax (Rmin (- ((1 * x1) * ((floor (Rmin (Rmax x1 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_one_sided_limited_1 : forall x0 x1 L,
  0 <= L -> kernel_held_one_sided_limited_1 x0 x1 L = controller true 0 None (Some L) x1 x1.
Proof. unfold kernel_held_one_sided_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_limited_2 (x0 x1 x2 L : R) : R :=
  (Rmax (Rmin (- ((1 * x2) * ((floor (Rmin (Rmax x2 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_one_sided_limited_2 : forall x0 x1 x2 L,
  0 <= L -> kernel_held_one_sided_limited_2 x0 x1 x2 L = controller true 0 None (Some L) x2 x2.
Proof. unfold kernel_held_one_sided_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_limited_3 (x0 x1 x2 x3 L : R) : R :=
  (Rmax (Rmin (- ((1 * x3) * ((floor (Rmin (Rmax x3 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_one_sided_limited_3 : forall x0 x1 x2 x3 L,
  0 <= L -> kernel_held_one_sided_limited_3 x0 x1 x2 x3 L = controller true 0 None (Some L) x3 x3.
Proof. unfold kernel_held_one_sided_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_limited_0 (x0 L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_encoder_one_sided_limited_0 : forall x0 L,
  0 <= L -> kernel_held_encoder_one_sided_limited_0 x0 L = controller true 0 None (Some L) (measured x0) (measured x0).
Proof. unfold kernel_held_encoder_one_sided_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_limited_1 (x0 x1 L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x1) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x1) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_encoder_one_sided_limited_1 : forall x0 x1 L,
  0 <= L -> kernel_held_encoder_one_sided_limited_1 x0 x1 L = controller true 0 None (Some L) (measured x1) (measured x1).
Proof. unfold kernel_held_encoder_one_sided_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_limited_2 (x0 x1 x2 L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x2) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x2) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_encoder_one_sided_limited_2 : forall x0 x1 x2 L,
  0 <= L -> kernel_held_encoder_one_sided_limited_2 x0 x1 x2 L = controller true 0 None (Some L) (measured x2) (measured x2).
Proof. unfold kernel_held_encoder_one_sided_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_limited_3 (x0 x1 x2 x3 L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x3) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x3) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_encoder_one_sided_limited_3 : forall x0 x1 x2 x3 L,
  0 <= L -> kernel_held_encoder_one_sided_limited_3 x0 x1 x2 x3 L = controller true 0 None (Some L) (measured x3) (measured x3).
Proof. unfold kernel_held_encoder_one_sided_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_limited_0 (x0 x1 B L : R) : R :=
  (Rmax (Rmin (- ((1 * x0) + ((- B) * (x1 - x0)))) L) (- L)).
Lemma bridge_held_damped_limited_0 : forall x0 x1 B L,
  0 <= L -> kernel_held_damped_limited_0 x0 x1 B L = controller false B None (Some L) x0 x1.
Proof. unfold kernel_held_damped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_limited_1 (x0 x1 x2 B L : R) : R :=
  (Rmax (Rmin (- ((1 * x1) + ((- B) * (x2 - x1)))) L) (- L)).
Lemma bridge_held_damped_limited_1 : forall x0 x1 x2 B L,
  0 <= L -> kernel_held_damped_limited_1 x0 x1 x2 B L = controller false B None (Some L) x1 x2.
Proof. unfold kernel_held_damped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_limited_2 (x0 x1 x2 x3 B L : R) : R :=
  (Rmax (Rmin (- ((1 * x2) + ((- B) * (x3 - x2)))) L) (- L)).
Lemma bridge_held_damped_limited_2 : forall x0 x1 x2 x3 B L,
  0 <= L -> kernel_held_damped_limited_2 x0 x1 x2 x3 B L = controller false B None (Some L) x2 x3.
Proof. unfold kernel_held_damped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_limited_3 (x0 x1 x2 x3 x4 B L : R) : R :=
  (Rmax (Rmin (- ((1 * x3) + ((- B) * (x4 - x3)))) L) (- L)).
Lemma bridge_held_damped_limited_3 : forall x0 x1 x2 x3 x4 B L,
  0 <= L -> kernel_held_damped_limited_3 x0 x1 x2 x3 x4 B L = controller false B None (Some L) x3 x4.
Proof. unfold kernel_held_damped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_limited_0 (x0 x1 B L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x0) + (1 / 2))) + ((- B) * (((floor x1) + (1 / 2)) - ((floor x0) + (1 / 2)))))) L) (- L)).
Lemma bridge_held_encoder_damped_limited_0 : forall x0 x1 B L,
  0 <= L -> kernel_held_encoder_damped_limited_0 x0 x1 B L = controller false B None (Some L) (measured x0) (measured x1).
Proof. unfold kernel_held_encoder_damped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_limited_1 (x0 x1 x2 B L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x1) + (1 / 2))) + ((- B) * (((floor x2) + (1 / 2)) - ((floor x1) + (1 / 2)))))) L) (- L)).
Lemma bridge_held_encoder_damped_limited_1 : forall x0 x1 x2 B L,
  0 <= L -> kernel_held_encoder_damped_limited_1 x0 x1 x2 B L = controller false B None (Some L) (measured x1) (measured x2).
Proof. unfold kernel_held_encoder_damped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_limited_2 (x0 x1 x2 x3 B L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x2) + (1 / 2))) + ((- B) * (((floor x3) + (1 / 2)) - ((floor x2) + (1 / 2)))))) L) (- L)).
Lemma bridge_held_encoder_damped_limited_2 : forall x0 x1 x2 x3 B L,
  0 <= L -> kernel_held_encoder_damped_limited_2 x0 x1 x2 x3 B L = controller false B None (Some L) (measured x2) (measured x3).
Proof. unfold kernel_held_encoder_damped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_limited_3 (x0 x1 x2 x3 x4 B L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x3) + (1 / 2))) + ((- B) * (((floor x4) + (1 / 2)) - ((floor x3) + (1 / 2)))))) L) (- L)).
Lemma bridge_held_encoder_damped_limited_3 : forall x0 x1 x2 x3 x4 B L,
  0 <= L -> kernel_held_encoder_damped_limited_3 x0 x1 x2 x3 x4 B L = controller false B None (Some L) (measured x3) (measured x4).
Proof. unfold kernel_held_encoder_damped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_limited_0 (x0 x1 B L : R) : R :=
  (Rmax (Rmin (- (((1 * x0) + ((- B) * (x1 - x0))) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_one_sided_damped_limited_0 : forall x0 x1 B L,
  0 <= L -> kernel_held_one_sided_damped_limited_0 x0 x1 B L = controller true B None (Some L) x0 x1.
Proof. unfold kernel_held_one_sided_damped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_limited_1 (x0 x1 x2 B L : R) : R :=
  (Rmax (Rmin (- (((1 * x1) + ((- B) * (x2 - x1))) * ((floor (Rmin (Rmax x1 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_one_sided_damped_limited_1 : forall x0 x1 x2 B L,
  0 <= L -> kernel_held_one_sided_damped_limited_1 x0 x1 x2 B L = controller true B None (Some L) x1 x2.
Proof. unfold kernel_held_one_sided_damped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_limited_2 (x0 x1 x2 x3 B L : R) : R :=
  (Rmax (Rmin (- (((1 * x2) + ((- B) * (x3 - x2))) * ((floor (Rmin (Rmax x2 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_one_sided_damped_limited_2 : forall x0 x1 x2 x3 B L,
  0 <= L -> kernel_held_one_sided_damped_limited_2 x0 x1 x2 x3 B L = controller true B None (Some L) x2 x3.
Proof. unfold kernel_held_one_sided_damped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_limited_3 (x0 x1 x2 x3 x4 B L : R) : R :=
  (Rmax (Rmin (- (((1 * x3) + ((- B) * (x4 - x3))) * ((floor (Rmin (Rmax x3 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_one_sided_damped_limited_3 : forall x0 x1 x2 x3 x4 B L,
  0 <= L -> kernel_held_one_sided_damped_limited_3 x0 x1 x2 x3 x4 B L = controller true B None (Some L) x3 x4.
Proof. unfold kernel_held_one_sided_damped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_limited_0 (x0 x1 B L : R) : R :=
  (Rmax (Rmin (- (((1 * ((floor x0) + (1 / 2))) + ((- B) * (((floor x1) + (1 / 2)) - ((floor x0) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_encoder_one_sided_damped_limited_0 : forall x0 x1 B L,
  0 <= L -> kernel_held_encoder_one_sided_damped_limited_0 x0 x1 B L = controller true B None (Some L) (measured x0) (measured x1).
Proof. unfold kernel_held_encoder_one_sided_damped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_limited_1 (x0 x1 x2 B L : R) : R :=
  (Rmax (Rmin (- (((1 * ((floor x1) + (1 / 2))) + ((- B) * (((floor x2) + (1 / 2)) - ((floor x1) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x1) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_encoder_one_sided_damped_limited_1 : forall x0 x1 x2 B L,
  0 <= L -> kernel_held_encoder_one_sided_damped_limited_1 x0 x1 x2 B L = controller true B None (Some L) (measured x1) (measured x2).
Proof. unfold kernel_held_encoder_one_sided_damped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_limited_2 (x0 x1 x2 x3 B L : R) : R :=
  (Rmax (Rmin (- (((1 * ((floor x2) + (1 / 2))) + ((- B) * (((floor x3) + (1 / 2)) - ((floor x2) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x2) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_encoder_one_sided_damped_limited_2 : forall x0 x1 x2 x3 B L,
  0 <= L -> kernel_held_encoder_one_sided_damped_limited_2 x0 x1 x2 x3 B L = controller true B None (Some L) (measured x2) (measured x3).
Proof. unfold kernel_held_encoder_one_sided_damped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_limited_3 (x0 x1 x2 x3 x4 B L : R) : R :=
  (Rmax (Rmin (- (((1 * ((floor x3) + (1 / 2))) + ((- B) * (((floor x4) + (1 / 2)) - ((floor x3) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x3) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_held_encoder_one_sided_damped_limited_3 : forall x0 x1 x2 x3 x4 B L,
  0 <= L -> kernel_held_encoder_one_sided_damped_limited_3 x0 x1 x2 x3 x4 B L = controller true B None (Some L) (measured x3) (measured x4).
Proof. unfold kernel_held_encoder_one_sided_damped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_stepped_limited_0 (x0 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * x0)) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_stepped_limited_0 : forall x0 delta L,
  0 <= L -> kernel_held_stepped_limited_0 x0 delta L = controller false 0 (Some delta) (Some L) x0 x0.
Proof. unfold kernel_held_stepped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_stepped_limited_1 (x0 x1 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * x1)) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_stepped_limited_1 : forall x0 x1 delta L,
  0 <= L -> kernel_held_stepped_limited_1 x0 x1 delta L = controller false 0 (Some delta) (Some L) x1 x1.
Proof. unfold kernel_held_stepped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_stepped_limited_2 (x0 x1 x2 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * x2)) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_stepped_limited_2 : forall x0 x1 x2 delta L,
  0 <= L -> kernel_held_stepped_limited_2 x0 x1 x2 delta L = controller false 0 (Some delta) (Some L) x2 x2.
Proof. unfold kernel_held_stepped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_stepped_limited_3 (x0 x1 x2 x3 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * x3)) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_stepped_limited_3 : forall x0 x1 x2 x3 delta L,
  0 <= L -> kernel_held_stepped_limited_3 x0 x1 x2 x3 delta L = controller false 0 (Some delta) (Some L) x3 x3.
Proof. unfold kernel_held_stepped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_stepped_limited_0 (x0 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * ((floor x0) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_stepped_limited_0 : forall x0 delta L,
  0 <= L -> kernel_held_encoder_stepped_limited_0 x0 delta L = controller false 0 (Some delta) (Some L) (measured x0) (measured x0).
Proof. unfold kernel_held_encoder_stepped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_stepped_limited_1 (x0 x1 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * ((floor x1) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_stepped_limited_1 : forall x0 x1 delta L,
  0 <= L -> kernel_held_encoder_stepped_limited_1 x0 x1 delta L = controller false 0 (Some delta) (Some L) (measured x1) (measured x1).
Proof. unfold kernel_held_encoder_stepped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_stepped_limited_2 (x0 x1 x2 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * ((floor x2) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_stepped_limited_2 : forall x0 x1 x2 delta L,
  0 <= L -> kernel_held_encoder_stepped_limited_2 x0 x1 x2 delta L = controller false 0 (Some delta) (Some L) (measured x2) (measured x2).
Proof. unfold kernel_held_encoder_stepped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_stepped_limited_3 (x0 x1 x2 x3 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * ((floor x3) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_stepped_limited_3 : forall x0 x1 x2 x3 delta L,
  0 <= L -> kernel_held_encoder_stepped_limited_3 x0 x1 x2 x3 delta L = controller false 0 (Some delta) (Some L) (measured x3) (measured x3).
Proof. unfold kernel_held_encoder_stepped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_stepped_limited_0 (x0 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_one_sided_stepped_limited_0 : forall x0 delta L,
  0 <= L -> kernel_held_one_sided_stepped_limited_0 x0 delta L = controller true 0 (Some delta) (Some L) x0 x0.
Proof. unfold kernel_held_one_sided_stepped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_stepped_limited_1 (x0 x1 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x1) * ((floor (Rmin (Rmax x1 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_one_sided_stepped_limited_1 : forall x0 x1 delta L,
  0 <= L -> kernel_held_one_sided_stepped_limited_1 x0 x1 delta L = controller true 0 (Some delta) (Some L) x1 x1.
Proof. unfold kernel_held_one_sided_stepped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_stepped_limited_2 (x0 x1 x2 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x2) * ((floor (Rmin (Rmax x2 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_one_sided_stepped_limited_2 : forall x0 x1 x2 delta L,
  0 <= L -> kernel_held_one_sided_stepped_limited_2 x0 x1 x2 delta L = controller true 0 (Some delta) (Some L) x2 x2.
Proof. unfold kernel_held_one_sided_stepped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_stepped_limited_3 (x0 x1 x2 x3 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x3) * ((floor (Rmin (Rmax x3 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_one_sided_stepped_limited_3 : forall x0 x1 x2 x3 delta L,
  0 <= L -> kernel_held_one_sided_stepped_limited_3 x0 x1 x2 x3 delta L = controller true 0 (Some delta) (Some L) x3 x3.
Proof. unfold kernel_held_one_sided_stepped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_stepped_limited_0 (x0 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_one_sided_stepped_limited_0 : forall x0 delta L,
  0 <= L -> kernel_held_encoder_one_sided_stepped_limited_0 x0 delta L = controller true 0 (Some delta) (Some L) (measured x0) (measured x0).
Proof. unfold kernel_held_encoder_one_sided_stepped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_stepped_limited_1 (x0 x1 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x1) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x1) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_one_sided_stepped_limited_1 : forall x0 x1 delta L,
  0 <= L -> kernel_held_encoder_one_sided_stepped_limited_1 x0 x1 delta L = controller true 0 (Some delta) (Some L) (measured x1) (measured x1).
Proof. unfold kernel_held_encoder_one_sided_stepped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_stepped_limited_2 (x0 x1 x2 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x2) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x2) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_one_sided_stepped_limited_2 : forall x0 x1 x2 delta L,
  0 <= L -> kernel_held_encoder_one_sided_stepped_limited_2 x0 x1 x2 delta L = controller true 0 (Some delta) (Some L) (measured x2) (measured x2).
Proof. unfold kernel_held_encoder_one_sided_stepped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_stepped_limited_3 (x0 x1 x2 x3 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x3) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x3) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_one_sided_stepped_limited_3 : forall x0 x1 x2 x3 delta L,
  0 <= L -> kernel_held_encoder_one_sided_stepped_limited_3 x0 x1 x2 x3 delta L = controller true 0 (Some delta) (Some L) (measured x3) (measured x3).
Proof. unfold kernel_held_encoder_one_sided_stepped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_stepped_limited_0 (x0 x1 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x0) + ((- B) * (x1 - x0)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_damped_stepped_limited_0 : forall x0 x1 B delta L,
  0 <= L -> kernel_held_damped_stepped_limited_0 x0 x1 B delta L = controller false B (Some delta) (Some L) x0 x1.
Proof. unfold kernel_held_damped_stepped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_stepped_limited_1 (x0 x1 x2 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x1) + ((- B) * (x2 - x1)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_damped_stepped_limited_1 : forall x0 x1 x2 B delta L,
  0 <= L -> kernel_held_damped_stepped_limited_1 x0 x1 x2 B delta L = controller false B (Some delta) (Some L) x1 x2.
Proof. unfold kernel_held_damped_stepped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_stepped_limited_2 (x0 x1 x2 x3 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x2) + ((- B) * (x3 - x2)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_damped_stepped_limited_2 : forall x0 x1 x2 x3 B delta L,
  0 <= L -> kernel_held_damped_stepped_limited_2 x0 x1 x2 x3 B delta L = controller false B (Some delta) (Some L) x2 x3.
Proof. unfold kernel_held_damped_stepped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_damped_stepped_limited_3 (x0 x1 x2 x3 x4 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x3) + ((- B) * (x4 - x3)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_damped_stepped_limited_3 : forall x0 x1 x2 x3 x4 B delta L,
  0 <= L -> kernel_held_damped_stepped_limited_3 x0 x1 x2 x3 x4 B delta L = controller false B (Some delta) (Some L) x3 x4.
Proof. unfold kernel_held_damped_stepped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_stepped_limited_0 (x0 x1 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x0) + (1 / 2))) + ((- B) * (((floor x1) + (1 / 2)) - ((floor x0) + (1 / 2)))))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_damped_stepped_limited_0 : forall x0 x1 B delta L,
  0 <= L -> kernel_held_encoder_damped_stepped_limited_0 x0 x1 B delta L = controller false B (Some delta) (Some L) (measured x0) (measured x1).
Proof. unfold kernel_held_encoder_damped_stepped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_stepped_limited_1 (x0 x1 x2 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x1) + (1 / 2))) + ((- B) * (((floor x2) + (1 / 2)) - ((floor x1) + (1 / 2)))))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_damped_stepped_limited_1 : forall x0 x1 x2 B delta L,
  0 <= L -> kernel_held_encoder_damped_stepped_limited_1 x0 x1 x2 B delta L = controller false B (Some delta) (Some L) (measured x1) (measured x2).
Proof. unfold kernel_held_encoder_damped_stepped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_stepped_limited_2 (x0 x1 x2 x3 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x2) + (1 / 2))) + ((- B) * (((floor x3) + (1 / 2)) - ((floor x2) + (1 / 2)))))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_damped_stepped_limited_2 : forall x0 x1 x2 x3 B delta L,
  0 <= L -> kernel_held_encoder_damped_stepped_limited_2 x0 x1 x2 x3 B delta L = controller false B (Some delta) (Some L) (measured x2) (measured x3).
Proof. unfold kernel_held_encoder_damped_stepped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_damped_stepped_limited_3 (x0 x1 x2 x3 x4 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x3) + (1 / 2))) + ((- B) * (((floor x4) + (1 / 2)) - ((floor x3) + (1 / 2)))))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_damped_stepped_limited_3 : forall x0 x1 x2 x3 x4 B delta L,
  0 <= L -> kernel_held_encoder_damped_stepped_limited_3 x0 x1 x2 x3 x4 B delta L = controller false B (Some delta) (Some L) (measured x3) (measured x4).
Proof. unfold kernel_held_encoder_damped_stepped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_stepped_limited_0 (x0 x1 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (((1 * x0) + ((- B) * (x1 - x0))) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_one_sided_damped_stepped_limited_0 : forall x0 x1 B delta L,
  0 <= L -> kernel_held_one_sided_damped_stepped_limited_0 x0 x1 B delta L = controller true B (Some delta) (Some L) x0 x1.
Proof. unfold kernel_held_one_sided_damped_stepped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_stepped_limited_1 (x0 x1 x2 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (((1 * x1) + ((- B) * (x2 - x1))) * ((floor (Rmin (Rmax x1 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_one_sided_damped_stepped_limited_1 : forall x0 x1 x2 B delta L,
  0 <= L -> kernel_held_one_sided_damped_stepped_limited_1 x0 x1 x2 B delta L = controller true B (Some delta) (Some L) x1 x2.
Proof. unfold kernel_held_one_sided_damped_stepped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_stepped_limited_2 (x0 x1 x2 x3 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (((1 * x2) + ((- B) * (x3 - x2))) * ((floor (Rmin (Rmax x2 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_one_sided_damped_stepped_limited_2 : forall x0 x1 x2 x3 B delta L,
  0 <= L -> kernel_held_one_sided_damped_stepped_limited_2 x0 x1 x2 x3 B delta L = controller true B (Some delta) (Some L) x2 x3.
Proof. unfold kernel_held_one_sided_damped_stepped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_one_sided_damped_stepped_limited_3 (x0 x1 x2 x3 x4 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (((1 * x3) + ((- B) * (x4 - x3))) * ((floor (Rmin (Rmax x3 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_one_sided_damped_stepped_limited_3 : forall x0 x1 x2 x3 x4 B delta L,
  0 <= L -> kernel_held_one_sided_damped_stepped_limited_3 x0 x1 x2 x3 x4 B delta L = controller true B (Some delta) (Some L) x3 x4.
Proof. unfold kernel_held_one_sided_damped_stepped_limited_3. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_stepped_limited_0 (x0 x1 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (((1 * ((floor x0) + (1 / 2))) + ((- B) * (((floor x1) + (1 / 2)) - ((floor x0) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_one_sided_damped_stepped_limited_0 : forall x0 x1 B delta L,
  0 <= L -> kernel_held_encoder_one_sided_damped_stepped_limited_0 x0 x1 B delta L = controller true B (Some delta) (Some L) (measured x0) (measured x1).
Proof. unfold kernel_held_encoder_one_sided_damped_stepped_limited_0. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_stepped_limited_1 (x0 x1 x2 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (((1 * ((floor x1) + (1 / 2))) + ((- B) * (((floor x2) + (1 / 2)) - ((floor x1) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x1) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_one_sided_damped_stepped_limited_1 : forall x0 x1 x2 B delta L,
  0 <= L -> kernel_held_encoder_one_sided_damped_stepped_limited_1 x0 x1 x2 B delta L = controller true B (Some delta) (Some L) (measured x1) (measured x2).
Proof. unfold kernel_held_encoder_one_sided_damped_stepped_limited_1. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_stepped_limited_2 (x0 x1 x2 x3 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (((1 * ((floor x2) + (1 / 2))) + ((- B) * (((floor x3) + (1 / 2)) - ((floor x2) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x2) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_one_sided_damped_stepped_limited_2 : forall x0 x1 x2 x3 B delta L,
  0 <= L -> kernel_held_encoder_one_sided_damped_stepped_limited_2 x0 x1 x2 x3 B delta L = controller true B (Some delta) (Some L) (measured x2) (measured x3).
Proof. unfold kernel_held_encoder_one_sided_damped_stepped_limited_2. bridge_controller. Qed.

(** [Controller::held_force] *)
Definition kernel_held_encoder_one_sided_damped_stepped_limited_3 (x0 x1 x2 x3 x4 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (((1 * ((floor x3) + (1 / 2))) + ((- B) * (((floor x4) + (1 / 2)) - ((floor x3) + (1 / 2))))) * ((floor (Rmin (Rmax ((floor x3) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_held_encoder_one_sided_damped_stepped_limited_3 : forall x0 x1 x2 x3 x4 B delta L,
  0 <= L -> kernel_held_encoder_one_sided_damped_stepped_limited_3 x0 x1 x2 x3 x4 B delta L = controller true B (Some delta) (Some L) (measured x3) (measured x4).
Proof. unfold kernel_held_encoder_one_sided_damped_stepped_limited_3. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_plain (x0 : R) : R :=
  (- (1 * x0)).
Lemma bridge_settled_plain : forall x0,
  kernel_settled_plain x0 = controller false 0 None None x0 x0.
Proof. unfold kernel_settled_plain. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder (x0 : R) : R :=
  (- (1 * ((floor x0) + (1 / 2)))).
Lemma bridge_settled_encoder : forall x0,
  kernel_settled_encoder x0 = controller false 0 None None (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_one_sided (x0 : R) : R :=
  (- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))).
Lemma bridge_settled_one_sided : forall x0,
  kernel_settled_one_sided x0 = controller true 0 None None x0 x0.
Proof. unfold kernel_settled_one_sided. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_one_sided (x0 : R) : R :=
  (- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_settled_encoder_one_sided : forall x0,
  kernel_settled_encoder_one_sided x0 = controller true 0 None None (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_one_sided. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_damped (x0 B : R) : R :=
  (- (1 * x0)).
Lemma bridge_settled_damped : forall x0 B,
  kernel_settled_damped x0 B = controller false B None None x0 x0.
Proof. unfold kernel_settled_damped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_damped (x0 B : R) : R :=
  (- (1 * ((floor x0) + (1 / 2)))).
Lemma bridge_settled_encoder_damped : forall x0 B,
  kernel_settled_encoder_damped x0 B = controller false B None None (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_damped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_one_sided_damped (x0 B : R) : R :=
  (- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))).
Lemma bridge_settled_one_sided_damped : forall x0 B,
  kernel_settled_one_sided_damped x0 B = controller true B None None x0 x0.
Proof. unfold kernel_settled_one_sided_damped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_one_sided_damped (x0 B : R) : R :=
  (- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))).
Lemma bridge_settled_encoder_one_sided_damped : forall x0 B,
  kernel_settled_encoder_one_sided_damped x0 B = controller true B None None (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_one_sided_damped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_stepped (x0 delta : R) : R :=
  (((floor ((((- (1 * x0)) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_settled_stepped : forall x0 delta,
  kernel_settled_stepped x0 delta = controller false 0 (Some delta) None x0 x0.
Proof. unfold kernel_settled_stepped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_stepped (x0 delta : R) : R :=
  (((floor ((((- (1 * ((floor x0) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_settled_encoder_stepped : forall x0 delta,
  kernel_settled_encoder_stepped x0 delta = controller false 0 (Some delta) None (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_stepped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_one_sided_stepped (x0 delta : R) : R :=
  (((floor ((((- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_settled_one_sided_stepped : forall x0 delta,
  kernel_settled_one_sided_stepped x0 delta = controller true 0 (Some delta) None x0 x0.
Proof. unfold kernel_settled_one_sided_stepped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_one_sided_stepped (x0 delta : R) : R :=
  (((floor ((((- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_settled_encoder_one_sided_stepped : forall x0 delta,
  kernel_settled_encoder_one_sided_stepped x0 delta = controller true 0 (Some delta) None (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_one_sided_stepped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_damped_stepped (x0 B delta : R) : R :=
  (((floor ((((- (1 * x0)) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_settled_damped_stepped : forall x0 B delta,
  kernel_settled_damped_stepped x0 B delta = controller false B (Some delta) None x0 x0.
Proof. unfold kernel_settled_damped_stepped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_damped_stepped (x0 B delta : R) : R :=
  (((floor ((((- (1 * ((floor x0) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_settled_encoder_damped_stepped : forall x0 B delta,
  kernel_settled_encoder_damped_stepped x0 B delta = controller false B (Some delta) None (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_damped_stepped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_one_sided_damped_stepped (x0 B delta : R) : R :=
  (((floor ((((- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_settled_one_sided_damped_stepped : forall x0 B delta,
  kernel_settled_one_sided_damped_stepped x0 B delta = controller true B (Some delta) None x0 x0.
Proof. unfold kernel_settled_one_sided_damped_stepped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_one_sided_damped_stepped (x0 B delta : R) : R :=
  (((floor ((((- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_settled_encoder_one_sided_damped_stepped : forall x0 B delta,
  kernel_settled_encoder_one_sided_damped_stepped x0 B delta = controller true B (Some delta) None (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_one_sided_damped_stepped. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_limited (x0 L : R) : R :=
  (Rmax (Rmin (- (1 * x0)) L) (- L)).
Lemma bridge_settled_limited : forall x0 L,
  0 <= L -> kernel_settled_limited x0 L = controller false 0 None (Some L) x0 x0.
Proof. unfold kernel_settled_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_limited (x0 L : R) : R :=
  (Rmax (Rmin (- (1 * ((floor x0) + (1 / 2)))) L) (- L)).
Lemma bridge_settled_encoder_limited : forall x0 L,
  0 <= L -> kernel_settled_encoder_limited x0 L = controller false 0 None (Some L) (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_one_sided_limited (x0 L : R) : R :=
  (Rmax (Rmin (- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_settled_one_sided_limited : forall x0 L,
  0 <= L -> kernel_settled_one_sided_limited x0 L = controller true 0 None (Some L) x0 x0.
Proof. unfold kernel_settled_one_sided_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_one_sided_limited (x0 L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_settled_encoder_one_sided_limited : forall x0 L,
  0 <= L -> kernel_settled_encoder_one_sided_limited x0 L = controller true 0 None (Some L) (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_one_sided_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_damped_limited (x0 B L : R) : R :=
  (Rmax (Rmin (- (1 * x0)) L) (- L)).
Lemma bridge_settled_damped_limited : forall x0 B L,
  0 <= L -> kernel_settled_damped_limited x0 B L = controller false B None (Some L) x0 x0.
Proof. unfold kernel_settled_damped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_damped_limited (x0 B L : R) : R :=
  (Rmax (Rmin (- (1 * ((floor x0) + (1 / 2)))) L) (- L)).
Lemma bridge_settled_encoder_damped_limited : forall x0 B L,
  0 <= L -> kernel_settled_encoder_damped_limited x0 B L = controller false B None (Some L) (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_damped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_one_sided_damped_limited (x0 B L : R) : R :=
  (Rmax (Rmin (- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_settled_one_sided_damped_limited : forall x0 B L,
  0 <= L -> kernel_settled_one_sided_damped_limited x0 B L = controller true B None (Some L) x0 x0.
Proof. unfold kernel_settled_one_sided_damped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_one_sided_damped_limited (x0 B L : R) : R :=
  (Rmax (Rmin (- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) L) (- L)).
Lemma bridge_settled_encoder_one_sided_damped_limited : forall x0 B L,
  0 <= L -> kernel_settled_encoder_one_sided_damped_limited x0 B L = controller true B None (Some L) (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_one_sided_damped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_stepped_limited (x0 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * x0)) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_settled_stepped_limited : forall x0 delta L,
  0 <= L -> kernel_settled_stepped_limited x0 delta L = controller false 0 (Some delta) (Some L) x0 x0.
Proof. unfold kernel_settled_stepped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_stepped_limited (x0 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * ((floor x0) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_settled_encoder_stepped_limited : forall x0 delta L,
  0 <= L -> kernel_settled_encoder_stepped_limited x0 delta L = controller false 0 (Some delta) (Some L) (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_stepped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_one_sided_stepped_limited (x0 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_settled_one_sided_stepped_limited : forall x0 delta L,
  0 <= L -> kernel_settled_one_sided_stepped_limited x0 delta L = controller true 0 (Some delta) (Some L) x0 x0.
Proof. unfold kernel_settled_one_sided_stepped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_one_sided_stepped_limited (x0 delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_settled_encoder_one_sided_stepped_limited : forall x0 delta L,
  0 <= L -> kernel_settled_encoder_one_sided_stepped_limited x0 delta L = controller true 0 (Some delta) (Some L) (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_one_sided_stepped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_damped_stepped_limited (x0 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * x0)) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_settled_damped_stepped_limited : forall x0 B delta L,
  0 <= L -> kernel_settled_damped_stepped_limited x0 B delta L = controller false B (Some delta) (Some L) x0 x0.
Proof. unfold kernel_settled_damped_stepped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_damped_stepped_limited (x0 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- (1 * ((floor x0) + (1 / 2)))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_settled_encoder_damped_stepped_limited : forall x0 B delta L,
  0 <= L -> kernel_settled_encoder_damped_stepped_limited x0 B delta L = controller false B (Some delta) (Some L) (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_damped_stepped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_one_sided_damped_stepped_limited (x0 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * x0) * ((floor (Rmin (Rmax x0 (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_settled_one_sided_damped_stepped_limited : forall x0 B delta L,
  0 <= L -> kernel_settled_one_sided_damped_stepped_limited x0 B delta L = controller true B (Some delta) (Some L) x0 x0.
Proof. unfold kernel_settled_one_sided_damped_stepped_limited. bridge_controller. Qed.

(** [Controller::settled] *)
Definition kernel_settled_encoder_one_sided_damped_stepped_limited (x0 B delta L : R) : R :=
  (Rmax (Rmin (((floor ((((- ((1 * ((floor x0) + (1 / 2))) * ((floor (Rmin (Rmax ((floor x0) + (1 / 2)) (- 1)) 0)) + 1))) * 1) / delta) + (1 / 2))) * delta) / 1) L) (- L)).
Lemma bridge_settled_encoder_one_sided_damped_stepped_limited : forall x0 B delta L,
  0 <= L -> kernel_settled_encoder_one_sided_damped_stepped_limited x0 B delta L = controller true B (Some delta) (Some L) (measured x0) (measured x0).
Proof. unfold kernel_settled_encoder_one_sided_damped_stepped_limited. bridge_controller. Qed.

(** [Loop::law] *)
Definition kernel_loop_law_plain (x : R) : R :=
  x.
Lemma bridge_loop_law_plain : forall x,
  kernel_loop_law_plain x = controller_law false None x.
Proof. unfold kernel_loop_law_plain. bridge_law. Qed.

(** [Loop::law] *)
Definition kernel_loop_potential_plain (x : R) : R :=
  ((x * x) - ((x * x) / 2)).
Lemma bridge_loop_potential_plain : forall x,
  kernel_loop_potential_plain x = controller_potential false None x.
Proof. unfold kernel_loop_potential_plain. bridge_law. Qed.

(** [Loop::law] *)
Definition kernel_loop_law_one_sided (x : R) : R :=
  (Rmax x 0).
Lemma bridge_loop_law_one_sided : forall x,
  kernel_loop_law_one_sided x = controller_law true None x.
Proof. unfold kernel_loop_law_one_sided. bridge_law. Qed.

(** [Loop::law] *)
Definition kernel_loop_potential_one_sided (x : R) : R :=
  ((x * (Rmax x 0)) - (((Rmax x 0) * (Rmax x 0)) / 2)).
Lemma bridge_loop_potential_one_sided : forall x,
  kernel_loop_potential_one_sided x = controller_potential true None x.
Proof. unfold kernel_loop_potential_one_sided. bridge_law. Qed.

(** [Loop::law] *)
Definition kernel_loop_law_limited (x L : R) : R :=
  (Rmin (Rmax x (- L)) L).
Lemma bridge_loop_law_limited : forall x L,
  0 <= L -> kernel_loop_law_limited x L = controller_law false (Some L) x.
Proof. unfold kernel_loop_law_limited. bridge_law. Qed.

(** [Loop::law] *)
Definition kernel_loop_potential_limited (x L : R) : R :=
  ((x * (Rmin (Rmax x (- L)) L)) - (((Rmin (Rmax x (- L)) L) * (Rmin (Rmax x (- L)) L)) / 2)).
Lemma bridge_loop_potential_limited : forall x L,
  0 <= L -> kernel_loop_potential_limited x L = controller_potential false (Some L) x.
Proof. unfold kernel_loop_potential_limited. bridge_law. Qed.

(** [Loop::law] *)
Definition kernel_loop_law_one_sided_limited (x L : R) : R :=
  (Rmin (Rmax x (Rmax 0 (- L))) L).
Lemma bridge_loop_law_one_sided_limited : forall x L,
  0 <= L -> kernel_loop_law_one_sided_limited x L = controller_law true (Some L) x.
Proof. unfold kernel_loop_law_one_sided_limited. bridge_law. Qed.

(** [Loop::law] *)
Definition kernel_loop_potential_one_sided_limited (x L : R) : R :=
  ((x * (Rmin (Rmax x (Rmax 0 (- L))) L)) - (((Rmin (Rmax x (Rmax 0 (- L))) L) * (Rmin (Rmax x (Rmax 0 (- L))) L)) / 2)).
Lemma bridge_loop_potential_one_sided_limited : forall x L,
  0 <= L -> kernel_loop_potential_one_sided_limited x L = controller_potential true (Some L) x.
Proof. unfold kernel_loop_potential_one_sided_limited. bridge_law. Qed.
