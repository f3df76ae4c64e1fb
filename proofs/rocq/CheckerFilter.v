(** * CheckerFilter: loops with any controller whose response ends, delay and damping together among them.

    The cost at an angle is a polynomial in its cosine, by Chebyshev's recursion (TH-LTI); the least
    number that it does not exceed is never computed: that a friction is enough is a sign on [-1, 1]. *)

From Coq Require Import Reals ZArith QArith Qreals Qabs Lra Lia Psatz List Bool RMicromega.
From Passivity Require Definitions.
From Passivity Require Import Model History Effects Controller Angles LinearController FiniteResponse
  Frequency Checker CheckerPolynomial CheckerFriction.
Import ListNotations.
Open Scope Q_scope.

(** g_0, g_1, ... of c_0, c_1, ..., the sums from each on. *)
Fixpoint tails (c : list Q) : list Q :=
  match c with
  | [] => []
  | a :: c => let t := tails c in Qred (a + hd 0 t) :: t
  end.

Fixpoint norm (c : list Q) : Q :=
  match c with
  | [] => 0
  | a :: c => Qred (Qabs a + norm c)
  end.

(** Numbers without their common denominator, which comes first. *)
Fixpoint cleared (l : list Q) : Z * list Z :=
  match l with
  | [] => (1, [])%Z
  | q :: l => let (m, zs) := cleared l in
              let d := Zpos (Qden q) in
              let g := Z.gcd m d in
              (m * (d / g), Qnum q * (m / g) :: times (d / g) zs)%Z
  end.

(** The sum of z_i T_(j+i) from T_j and T_(j+1), Chebyshev's. *)
Fixpoint combination (before now : poly) (zs : list Z) : poly :=
  match zs with
  | [] => []
  | z :: zs => plus (times z before)
                    (combination now (plus (product [0; 2]%Z now) (times (-1) before)) zs)
  end.

(** A multiple of what [beta] leaves at an angle, in its cosine. *)
Definition filter_polynomial (c : list Q) (beta : Q) : poly :=
  let t := tails c in
  combination [1]%Z [0; 1]%Z (snd (cleared (beta - hd 0 t / 2 :: map Qopp (tl t)))).

Definition filter_decides (c : list Q) (beta : Q) : answer :=
  nonnegative_on_cosines (filter_polynomial c beta).

(** The verdict on a loop under the controller c_0, c_1, ..., in units of the wall. *)
Definition check_filter (l : loop) (c : list Q) : outcome :=
  if Qle_bool 0 (hd 0 (tails c)) then over_friction l (norm c / 2) (filter_decides c) else Invalid.

(** [k] samples late. *)
Definition late (k : nat) (c : list Q) : list Q := repeat 0 k ++ c.

(** The wall with virtual damping [B], [k] samples late. *)
Definition check_damped (l : loop) (k : nat) (B : Q) : outcome :=
  let damping := Qred (B / (l_K l * l_T l)) in check_filter l (late k [1 + damping; - damping]).

(** ** Soundness *)

Open Scope R_scope.

Definition coefficient (c : list Q) (j : nat) : R := Q2R (nth j c 0%Q).

Lemma Qred_is : forall q, Q2R (Qred q) = Q2R q.
Proof. intro q. apply Qeq_eqR, Qred_correct. Qed.

Lemma tail_later : forall a c j,
  tail (coefficient (a :: c)) (S (length c)) (S j) = tail (coefficient c) (length c) j.
Proof. reflexivity. Qed.

Lemma tails_are : forall c j, Q2R (nth j (tails c) 0%Q) = tail (coefficient c) (length c) j.
Proof.
  induction c as [| a c IH]; intro j.
  - assert (Z : tail (coefficient []) (length (@nil Q)) j = 0).
    { unfold tail, coefficient. simpl length. destruct (Nat.leb j 0); [| reflexivity].
      simpl (0 - j)%nat. simpl. destruct (j + 0)%nat; apply Q2R_0. }
    rewrite Z. simpl. destruct j; apply Q2R_0.
  - destruct j as [| j]; cbn [tails nth].
    + rewrite Qred_is, Q2R_plus.
      pose proof (tail_step (coefficient (a :: c)) (length (a :: c)) 0 ltac:(lia)) as S.
      simpl length in *. rewrite tail_later in S. rewrite <- IH in S.
      replace (hd 0%Q (tails c)) with (nth 0 (tails c) 0%Q) by (destruct (tails c); reflexivity).
      change (coefficient (a :: c) 0) with (Q2R a) in S. lra.
    + rewrite IH. symmetry. apply tail_later.
Qed.

Lemma Q2R_abs : forall q, Q2R (Qabs q) = Rabs (Q2R q).
Proof.
  intro q. apply Qabs_case; intro H; apply Qle_Rle in H; rewrite Q2R_0 in H.
  - rewrite Rabs_right; lra.
  - rewrite Q2R_opp, Rabs_left1; lra.
Qed.

Lemma norm_is : forall c, Q2R (norm c) = response_norm (coefficient c) (length c).
Proof.
  induction c as [| a c IH].
  - unfold response_norm, coefficient. simpl. rewrite Q2R_0, Rabs_R0. reflexivity.
  - cbn [norm]. rewrite Qred_is, Q2R_plus, Q2R_abs, IH. unfold response_norm. simpl length.
    rewrite (decomp_sum _ (S (length c))) by lia. reflexivity.
Qed.

(** ** The polynomial *)

Fixpoint series (l : list R) (j : nat) (x : R) : R :=
  match l with
  | [] => 0
  | a :: l => a * chebyshev j x + series l (S j) x
  end.

Lemma value_combination : forall zs before now j x,
  value before x = chebyshev j x -> value now x = chebyshev (S j) x ->
  value (combination before now zs) x = series (map IZR zs) j x.
Proof.
  induction zs as [| z zs IH]; intros before now j x E0 E1; [reflexivity |].
  cbn [combination map series]. rewrite value_plus, value_times, E0, (IH _ _ (S j)); [ring | exact E1 |].
  rewrite value_plus, value_times, value_product, E0, E1.
  change (chebyshev (S (S j)) x) with (2 * x * chebyshev (S j) x - chebyshev j x). simpl. ring.
Qed.

Lemma series_times : forall k zs j x, series (map IZR (times k zs)) j x = IZR k * series (map IZR zs) j x.
Proof.
  intros k zs. induction zs as [| z zs IH]; intros j x; simpl; [ring |].
  unfold times in IH. rewrite IH, mult_IZR. ring.
Qed.

Lemma series_cleared : forall l, (0 < fst (cleared l))%Z /\
  forall j x, series (map IZR (snd (cleared l))) j x = IZR (fst (cleared l)) * series (map Q2R l) j x.
Proof.
  induction l as [| q l [P IH]]; [split; [reflexivity | intros; simpl; ring] |].
  cbn [cleared]. destruct (cleared l) as [m zs]. cbn [fst snd] in *.
  set (d := Zpos (Qden q)). set (g := Z.gcd m d).
  assert (D0 : (0 < d)%Z) by reflexivity.
  assert (G0 : (0 < g)%Z).
  { pose proof (Z.gcd_nonneg m d). destruct (Z.eq_dec g 0) as [E |]; [| lia].
    apply Z.gcd_eq_0_l in E. lia. }
  assert (Em : m = (g * (m / g))%Z) by (apply Z_div_exact_full_2; [lia |];
    apply Z.mod_divide; [lia | apply Z.gcd_divide_l]).
  assert (Ed : d = (g * (d / g))%Z) by (apply Z_div_exact_full_2; [lia |];
    apply Z.mod_divide; [lia | apply Z.gcd_divide_r]).
  set (m' := (m / g)%Z) in *. set (d' := (d / g)%Z) in *.
  split; [nia |]. intros j x. cbn [map series]. rewrite series_times, IH, !mult_IZR.
  assert (Eq : Q2R q * IZR d = IZR (Qnum q)) by (unfold Q2R; fold d; field; apply not_0_IZR; lia).
  rewrite Em, Ed in *. rewrite !mult_IZR in *.
  assert (IZR g <> 0) by (apply not_0_IZR; lia). rewrite <- Eq. ring.
Qed.

Lemma series_opp : forall l j x, series (map Q2R (map Qopp l)) j x = - series (map Q2R l) j x.
Proof.
  induction l as [| q l IH]; intros j x; simpl; [ring |]. rewrite IH, Q2R_opp. ring.
Qed.

Lemma series_sum : forall l j x N, (length l <= N)%nat ->
  series (map Q2R l) (S j) x = Definitions.sum_to N (fun i => Q2R (nth (pred i) l 0%Q) * chebyshev (j + i) x).
Proof.
  induction l as [| q l IH]; intros j x N HN.
  - symmetry. apply sum_to_zero. intros i _. destruct (pred i); simpl; rewrite Q2R_0; ring.
  - destruct N as [| N]; [simpl in HN; lia |]. rewrite sum_to_first. cbn [map series].
    simpl in HN. rewrite (IH (S j) x N) by lia. f_equal.
    + simpl pred. simpl nth. replace (j + 1)%nat with (S j) by lia. reflexivity.
    + apply sum_to_ext. intros [| i] Hi; [lia |]. simpl pred. simpl nth.
      replace (S j + S i)%nat with (j + S (S i))%nat by lia. reflexivity.
Qed.

Section Filter.

Variable c : list Q.
Let n := length c.
Let g := tail (coefficient c) n.

(** The cost at no angle is above [lambda]. *)
Definition filter_cost (lambda : R) : Prop := forall theta, symbol (g 0%nat) g n theta <= lambda.

Lemma at_one_is : Q2R (hd 0%Q (tails c)) = g 0%nat.
Proof. unfold g. rewrite <- tails_are. destruct (tails c); reflexivity. Qed.

Lemma filter_polynomial_is : forall beta, exists M, 0 < M /\ forall x,
  value (filter_polynomial c beta) x = M * (Q2R beta - symbol_polynomial (g 0%nat) g n x).
Proof.
  intro beta. set (l := (beta - hd 0 (tails c) / 2 :: map Qopp (tl (tails c)))%Q).
  destruct (series_cleared l) as [P E]. exists (IZR (fst (cleared l))).
  split; [apply IZR_lt, P |]. intro x. unfold filter_polynomial. fold l.
  rewrite (value_combination _ _ _ 0) by (simpl; ring). rewrite E. f_equal. unfold l.
  cbn [map series]. rewrite series_opp, (series_sum _ 0 x n).
  2: { unfold n. clear. assert (L : length (tails c) = length c)
         by (induction c as [| a d IH]; [reflexivity | simpl; rewrite IH; reflexivity]).
       rewrite <- L. destruct (tails c); simpl; lia. }
  rewrite Q2R_minus, Q2R_quotient, Q2R_two, at_one_is. unfold symbol_polynomial.
  rewrite (sum_to_ext n (fun i => Q2R (nth (pred i) (tl (tails c)) 0%Q) * chebyshev (0 + i) x)
    (fun j => g j * chebyshev j x)).
  - simpl chebyshev. ring.
  - intros [| i] Hi; [lia |]. unfold g. rewrite <- tails_are. simpl pred.
    destruct (tails c); simpl; [destruct i |]; reflexivity.
Qed.

Lemma filter_enough : forall beta, filter_decides c beta = Enough -> filter_cost (Q2R beta).
Proof.
  intros beta E. unfold filter_cost. apply TH_LTI_polynomial. intros x Hx.
  destruct (filter_polynomial_is beta) as (M & HM & V).
  pose proof (nonnegative_enough _ E x Hx) as P. rewrite V in P.
  apply Rmult_le_reg_l with M; [exact HM | lra].
Qed.

Lemma filter_short : forall beta, filter_decides c beta = Short -> ~ filter_cost (Q2R beta).
Proof.
  intros beta E C. destruct (filter_polynomial_is beta) as (M & HM & V).
  destruct (nonnegative_short _ E) as (x & Hx & P). rewrite V in P.
  pose proof (proj1 (TH_LTI_polynomial _ _ _ _) C x Hx) as N.
  assert (0 <= M * (Q2R beta - symbol_polynomial (g 0%nat) g n x)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma filter_more : forall x y, x <= y -> filter_cost x -> filter_cost y.
Proof. intros x y L C theta. specialize (C theta). lra. Qed.

Lemma half_norm : Q2R (norm c / 2) = response_norm (coefficient c) n / 2.
Proof. rewrite Q2R_quotient, Q2R_two, norm_is. reflexivity. Qed.

Lemma check_filter_is : forall l v, check_filter l c = Says v ->
  over_friction l (norm c / 2) (filter_decides c) = Says v /\ loop_valid l = true /\ 0 <= g 0%nat.
Proof.
  intros l v H. unfold check_filter in H. destruct Qle_bool eqn:S; [| discriminate].
  apply le_bool in S. rewrite Q2R_0, at_one_is in S.
  split; [exact H | split; [exact (outcome_valid _ _ _ _ H) | exact S]].
Qed.

(** CHECK (filter, fails): at no friction within its tolerances does the criterion hold with a number
    that the cost exceeds at no angle. *)
Theorem CHECK_filter_fails : forall l, check_filter l c = Says Fails ->
  forall rb rc, friction_in l rb rc ->
  forall lambda, filter_cost lambda -> ~ meets l (response_norm (coefficient c) n / 2) rb rc lambda.
Proof.
  intros l H. destruct (check_filter_is l _ H) as (O & Ok & _). rewrite <- half_norm.
  exact (over_friction_fails l _ _ _ filter_more filter_short Ok O).
Qed.

(** CHECK (filter, depends): at some friction within its tolerances it does, at some it does not. *)
Theorem CHECK_filter_depends : forall l, check_filter l c = Says Depends ->
  (exists rb rc, friction_in l rb rc /\ exists lambda, filter_cost lambda /\
     meets l (response_norm (coefficient c) n / 2) rb rc lambda) /\
  (exists rb rc, friction_in l rb rc /\ forall lambda, filter_cost lambda ->
     ~ meets l (response_norm (coefficient c) n / 2) rb rc lambda).
Proof.
  intros l H. destruct (check_filter_is l _ H) as (O & Ok & _). rewrite <- half_norm.
  exact (over_friction_depends l _ _ _ filter_more filter_enough filter_short Ok O).
Qed.

(** CHECK (filter, holds): there is a number that the cost exceeds at no angle with which it holds. *)
Theorem CHECK_filter_holds : forall l, check_filter l c = Says Holds ->
  forall rb rc, friction_in l rb rc ->
  exists lambda, filter_cost lambda /\ meets l (response_norm (coefficient c) n / 2) rb rc lambda.
Proof.
  intros l H. destruct (check_filter_is l _ H) as (O & Ok & _). rewrite <- half_norm.
  exact (over_friction_holds l _ _ _ filter_enough Ok O).
Qed.

(** CHECK (filter, motion): where the verdict is Holds, every motion of every loop within the
    tolerances is passive at the speeds asked for, whatever it was before the start. *)
Theorem CHECK_filter_motion : forall l, check_filter l c = Says Holds ->
  forall rb rc, friction_in l rb rc -> exists lambda, filter_cost lambda /\
  forall u mu pos vel friction hand past step, length_unit l u ->
  let beta := Definitions.beta_of rb (Q2R (l_K l)) (Q2R (l_T l)) in
  let sigma := Definitions.sigma_of rc (Q2R (l_K l)) u in
  physical mu beta sigma -> step_positive step ->
  step_size step = Q2R (number (l_F l)) / (Q2R (l_K l) * u) ->
  obeys mu beta sigma INR (held_by_filter pos past (coefficient c) n step (measuring l))
    pos vel friction hand ->
  forall t, 0 <= t -> slow_enough l u vel t ->
  passive_run vel hand
    (Definitions.kinetic mu (vel 0) + spring_potential (g 0%nat) (pos 0)
     + filter_memory pos past (coefficient c) n lambda)
    (Definitions.kinetic mu (vel t) + spring_potential (g 0%nat) (pos t)) t.
Proof.
  intros l H rb rc I. destruct (check_filter_is l _ H) as (_ & Ok & G).
  destruct (CHECK_filter_holds l H rb rc I) as (lambda & C & M). exists lambda. split; [exact C |].
  intros u mu pos vel friction hand past step Hu beta sigma P S Es O t Ht Slow.
  apply (TH_LTI_fir mu beta sigma pos vel friction hand past (coefficient c) n lambda step
    (measuring l) (measuring_error l) P S (measuring_off l) G C O t Ht).
  apply (meets_motion l Ok _ rb rc lambda M u); [exact Hu | field | exact Es | exact Slow].
Qed.

End Filter.
