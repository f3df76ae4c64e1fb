(** * CheckerPolynomial: whether a polynomial with whole coefficients is negative somewhere on [-1, 1].

    An interval is mapped to 0 <= t: where no coefficient of what comes out is below 0, neither is the
    polynomial on the interval (Bernstein).  Where one is, the interval is halved.  Where the polynomial
    only touches 0 that never ends, and so the squared factor of it is looked for and divided out: the
    division is not trusted, its result is multiplied out and compared. *)

From Coq Require Import Reals ZArith Lra Lia Psatz List Bool.
Import ListNotations.
Open Scope Z_scope.

(** a_0 + a_1 x + ..., as the list of its coefficients. *)
Definition poly := list Z.

Fixpoint plus (p q : poly) : poly :=
  match p, q with
  | [], _ => q
  | _, [] => p
  | a :: p, b :: q => a + b :: plus p q
  end.

Definition times (a : Z) (p : poly) : poly := map (Z.mul a) p.

Fixpoint product (p q : poly) : poly :=
  match p with
  | [] => []
  | a :: p => plus (times a q) (0 :: product p q)
  end.

(** ** Signs *)

(** (u + v t) p. *)
Definition linear (u v : Z) (p : poly) : poly := plus (times u p) (0 :: times v p).

(** d^n p ((u + v t)/d) over d = r + s t, as a polynomial in t, n the length of p; and d^n. *)
Fixpoint mapped (u v r s : Z) (p : poly) : poly * poly :=
  match p with
  | [] => ([], [1])
  | a :: p => let (q, d) := mapped u v r s p in (plus (times a d) (linear u v q), linear r s d)
  end.

(** Whether p (u/w) is below 0. *)
Definition negative_at (p : poly) (u w : Z) : bool := hd 0 (fst (mapped u 0 w 0 p)) <? 0.

(** Enough: not below 0.  Short: below 0 somewhere.  Untold: the fuel ran out. *)
Inductive answer := Enough | Short | Untold.

(** Whether [q] is not below 0 for 0 <= t; else a point of [u/w, v/w) at which [p] is below 0, where
    t = 0 stands for u/w, and all t for the interval. *)
Fixpoint over (fuel : nat) (q p : poly) (u v w : Z) : answer :=
  if forallb (Z.leb 0) q then Enough
  else if (hd 0 q <? 0) && negative_at p u w then Short
  else match fuel with
  | O => Untold
  | S fuel =>
    match over fuel (fst (mapped 0 1 2 1 q)) p (2 * u) (u + v) (2 * w) with
    | Short => Short
    | told => match over fuel (fst (mapped 1 2 1 0 q)) p (u + v) (2 * v) (2 * w) with
              | Short => Short
              | Untold => Untold
              | Enough => told
              end
    end
  end.

Definition over_cosines (fuel : nat) (q p : poly) : answer :=
  over fuel (fst (mapped (-1) 1 1 1 q)) p (-1) 1 1.

(** ** Squared factors, by Euclid's algorithm without fractions

    The coefficients of the highest power come first here. *)

Fixpoint minus_front (p q : poly) : poly :=
  match p, q with
  | a :: p, b :: q => a - b :: minus_front p q
  | _, [] => p
  | [], _ => []
  end.

Fixpoint divided (fuel : nat) (p q quotient : poly) : poly * poly :=
  match fuel, p, q with
  | S fuel, a :: p', b :: q' =>
    if Nat.ltb (length p) (length q) then (quotient, p)
    else divided fuel (minus_front (times b p') (times a q')) q (a :: times b quotient)
  | _, _, _ => (quotient, p)
  end.

Fixpoint stripped (p : poly) : poly :=
  match p with
  | 0 :: p => stripped p
  | _ => p
  end.

Definition primitive (p : poly) : poly :=
  let g := fold_right Z.gcd 0 p in map (fun a => a / g) p.

Fixpoint common (fuel : nat) (p q : poly) : poly :=
  match fuel, stripped q with
  | S fuel, (_ :: _) as q => common fuel q (primitive (snd (divided (length p) p q [])))
  | _, _ => p
  end.

Fixpoint slopes (j : Z) (p : poly) : poly :=
  match p with
  | [] => []
  | a :: p => j * a :: slopes (j + 1) p
  end.

Definition derived (p : poly) : poly := stripped (rev (tl (slopes 0 (rev p)))).

Definition over_factor (p q : poly) : poly := rev (primitive (fst (divided (length p) p q []))).

(** The product of the factors that [p] has more than once. *)
Definition repeated (p : poly) : poly :=
  let g := common (length p) p (derived p) in over_factor g (common (length g) g (derived g)).

(** What is left of a polynomial without squared factors; the lowest power first. *)
Fixpoint squarefree (fuel : nat) (p : poly) : poly :=
  match fuel with
  | O => p
  | S fuel =>
    let f := stripped (rev p) in
    let s := repeated f in
    let h := rev (over_factor (over_factor f s) s) in
    let square := product (rev s) (rev s) in
    let m := hd 0 f in
    let k := hd 0 (stripped (rev (product square h))) in
    let h := if m * k <? 0 then times (-1) h else h in
    if negb (k =? 0) && (1 <? Z.of_nat (length s))
       && forallb (Z.eqb 0) (plus (times (Z.abs k) p) (times (- Z.abs m) (product square h)))
    then squarefree fuel h else p
  end.

(** How often an interval is halved at first, and without squared factors. *)
Definition first_halvings : nat := 60.
Definition most_halvings : nat := 200.

Definition nonnegative_on_cosines (p : poly) : answer :=
  if negative_at p 1 1 then Short
  else match over_cosines first_halvings p p with
  | Untold => over_cosines most_halvings (squarefree (length p) p) p
  | told => told
  end.

(** ** Soundness *)

Open Scope R_scope.

Fixpoint value (p : poly) (x : R) : R :=
  match p with
  | [] => 0
  | a :: p => IZR a + x * value p x
  end.

Lemma value_plus : forall p q x, value (plus p q) x = value p x + value q x.
Proof.
  induction p as [| a p IH]; intros [| b q] x; simpl; try ring.
  rewrite IH, plus_IZR. ring.
Qed.

Lemma value_times : forall a p x, value (times a p) x = IZR a * value p x.
Proof.
  intros a p x. unfold times. induction p as [| b p IH]; simpl; [ring |].
  rewrite IH, mult_IZR. ring.
Qed.

Lemma value_product : forall p q x, value (product p q) x = value p x * value q x.
Proof.
  induction p as [| a p IH]; intros q x; simpl; [ring |].
  rewrite value_plus, value_times. simpl. rewrite IH. ring.
Qed.

Lemma value_zero : forall p x, forallb (Z.eqb 0) p = true -> value p x = 0.
Proof.
  induction p as [| a p IH]; intros x Z0; cbn [forallb value] in *; [reflexivity |].
  apply andb_true_iff in Z0. destruct Z0 as [A Z0]. apply Z.eqb_eq in A. rewrite <- A, IH by exact Z0. ring.
Qed.

Lemma value_nonneg : forall p t, 0 <= t -> forallb (Z.leb 0) p = true -> 0 <= value p t.
Proof.
  induction p as [| a p IH]; intros t Ht P; simpl in *; [lra |].
  apply andb_true_iff in P. destruct P as [A P]. apply Z.leb_le, IZR_le in A.
  specialize (IH t Ht P). nra.
Qed.

Lemma value_start : forall p, value p 0 = IZR (hd 0%Z p).
Proof. intros [| a p]; simpl; ring. Qed.

Lemma value_linear : forall u v p x, value (linear u v p) x = (IZR u + IZR v * x) * value p x.
Proof. intros. unfold linear. rewrite value_plus, value_times. simpl. rewrite value_times. ring. Qed.

(** Times its denominator the mapped polynomial is the denominator to the length, times p. *)
Lemma mapped_is : forall u v r s p t x, x * (IZR r + IZR s * t) = IZR u + IZR v * t ->
  value (snd (mapped u v r s p)) t = (IZR r + IZR s * t) ^ length p /\
  (IZR r + IZR s * t) * value (fst (mapped u v r s p)) t = (IZR r + IZR s * t) ^ length p * value p x.
Proof.
  intros u v r s p t x E. induction p as [| a p [IH1 IH2]]; [simpl; split; ring |].
  cbn [mapped]. destruct (mapped u v r s p) as [q d]. cbn [fst snd length value pow] in *.
  rewrite value_plus, value_times, !value_linear, IH1. split; [ring |].
  rewrite <- E. set (W := IZR r + IZR s * t) in *.
  replace (W * (IZR a * W ^ length p + x * W * value q t))
    with (W * IZR a * W ^ length p + x * W * (W * value q t)) by ring.
  rewrite IH2. ring.
Qed.

(** What is not negative after a map was not before. *)
Lemma mapped_nonneg : forall u v r s p t x, x * (IZR r + IZR s * t) = IZR u + IZR v * t ->
  0 < IZR r + IZR s * t -> 0 <= value (fst (mapped u v r s p)) t -> 0 <= value p x.
Proof.
  intros u v r s p t x E P V. destruct (mapped_is u v r s p t x E) as [_ M].
  pose proof (pow_lt _ (length p) P). nra.
Qed.

Lemma at_fraction : forall p u w, (0 < w)%Z ->
  IZR w * IZR (hd 0%Z (fst (mapped u 0 w 0 p))) = IZR w ^ length p * value p (IZR u / IZR w).
Proof.
  intros p u w Hw. apply IZR_lt in Hw.
  destruct (mapped_is u 0 w 0 p 0 (IZR u / IZR w)) as [_ E]; [field; lra |].
  rewrite value_start in E. rewrite Rmult_0_r, Rplus_0_r in E. exact E.
Qed.

Lemma negative_at_is : forall p u w, (0 < w)%Z -> negative_at p u w = true ->
  value p (IZR u / IZR w) < 0.
Proof.
  intros p u w Hw N. unfold negative_at in N. apply Z.ltb_lt, IZR_lt in N.
  pose proof (at_fraction p u w Hw) as E. apply IZR_lt in Hw.
  pose proof (pow_lt _ (length p) Hw). nra.
Qed.

Lemma not_negative_at : forall p u w, (0 < w)%Z -> negative_at p u w = false ->
  0 <= value p (IZR u / IZR w).
Proof.
  intros p u w Hw N. unfold negative_at in N. apply Z.ltb_ge, IZR_le in N.
  pose proof (at_fraction p u w Hw) as E. apply IZR_lt in Hw.
  pose proof (pow_lt _ (length p) Hw). nra.
Qed.

Lemma over_enough : forall fuel q p u v w, over fuel q p u v w = Enough ->
  forall t, 0 <= t -> 0 <= value q t.
Proof.
  induction fuel as [| fuel IH]; intros q p u v w E t Ht; cbn [over] in E;
    (destruct (forallb (Z.leb 0) q) eqn:M; [exact (value_nonneg q t Ht M) |]);
    destruct ((hd 0%Z q <? 0)%Z && negative_at p u w); try discriminate.
  set (left := fst (mapped 0 1 2 1 q)) in *. set (right := fst (mapped 1 2 1 0 q)) in *.
  destruct (over fuel left p _ _ _) eqn:L; try discriminate;
    destruct (over fuel right p _ _ _) eqn:R; try discriminate.
  destruct (Rlt_le_dec t 1) as [B | B].
  - pose proof (IH _ _ _ _ _ L (2 * t / (1 - t))) as S.
    assert (0 < / (1 - t)) by (apply Rinv_0_lt_compat; lra).
    assert (0 <= 2 * t / (1 - t)) by (apply Rmult_le_pos; lra).
    apply (mapped_nonneg 0 1 2 1 q (2 * t / (1 - t))); [field; lra | lra | apply S; lra].
  - pose proof (IH _ _ _ _ _ R ((t - 1) / 2)) as S.
    apply (mapped_nonneg 1 2 1 0 q ((t - 1) / 2)); [field | lra | apply S; lra].
Qed.

Lemma halves : forall u v w, (0 < w)%Z -> (u < v)%Z ->
  IZR (2 * u) / IZR (2 * w) = IZR u / IZR w /\ IZR (2 * v) / IZR (2 * w) = IZR v / IZR w /\
  IZR u / IZR w < IZR (u + v) / IZR (2 * w) < IZR v / IZR w.
Proof.
  intros u v w Hw Huv. apply IZR_lt in Hw. apply IZR_lt in Huv.
  assert (E : IZR (2 * u) / IZR (2 * w) = IZR u / IZR w) by (rewrite !mult_IZR; field; lra).
  assert (F : IZR (2 * v) / IZR (2 * w) = IZR v / IZR w) by (rewrite !mult_IZR; field; lra).
  split; [exact E | split; [exact F |]]. rewrite <- E, <- F, plus_IZR, !mult_IZR.
  split; apply Rmult_lt_compat_r; try (apply Rinv_0_lt_compat; lra); lra.
Qed.

Lemma over_short : forall fuel q p u v w, (0 < w)%Z -> (u < v)%Z -> over fuel q p u v w = Short ->
  exists x, IZR u / IZR w <= x < IZR v / IZR w /\ value p x < 0.
Proof.
  induction fuel as [| fuel IH]; intros q p u v w Hw Huv E; cbn [over] in E;
    destruct (forallb (Z.leb 0) q); try discriminate;
    (destruct ((hd 0%Z q <? 0)%Z && negative_at p u w) eqn:N;
      [apply andb_true_iff in N; destruct N as [_ N]; exists (IZR u / IZR w);
       split; [destruct (halves u v w Hw Huv) as (_ & _ & L); split;
         [apply Rle_refl | exact (Rlt_trans _ _ _ (proj1 L) (proj2 L))] | apply negative_at_is; assumption] |]);
    try discriminate.
  destruct (halves u v w Hw Huv) as (Hu & Hv & M).
  destruct (over fuel (fst (mapped 0 1 2 1 q)) p _ _ _) eqn:L;
    [| destruct (IH _ p (2 * u) (u + v) (2 * w) ltac:(lia) ltac:(lia) L)%Z as (x & [X0 X1] & V); exists x;
       rewrite Hu in X0;
       exact (conj (conj X0 (Rlt_trans _ _ _ X1 (proj2 M))) V) |];
    (destruct (over fuel (fst (mapped 1 2 1 0 q)) p _ _ _) eqn:R; try discriminate;
     destruct (IH _ p (u + v) (2 * v) (2 * w) ltac:(lia) ltac:(lia) R)%Z as (x & [X0 X1] & V); exists x;
     rewrite Hv in X1;
     exact (conj (conj (Rlt_le _ _ (Rlt_le_trans _ _ _ (proj1 M) X0)) X1) V)).
Qed.

(** Where what is left is not below 0, the polynomial is not. *)
Lemma squarefree_enough : forall fuel p x, 0 <= value (squarefree fuel p) x -> 0 <= value p x.
Proof.
  induction fuel as [| fuel IH]; intros p x; [tauto |]. cbn [squarefree].
  set (f := stripped (rev p)). set (s := repeated f).
  set (h0 := rev (over_factor (over_factor f s) s)).
  set (k := hd 0%Z (stripped (rev (product (product (rev s) (rev s)) h0)))).
  set (h := if (hd 0 f * k <? 0)%Z then times (-1) h0 else h0). cbv zeta.
  destruct (_ && _ && _) eqn:C; [| tauto]. intro H. apply IH in H.
  rewrite !andb_true_iff, negb_true_iff in C. destruct C as [[K _] E].
  apply Z.eqb_neq in K. assert (K0 : 0 < IZR (Z.abs k)) by (apply IZR_lt; lia).
  apply (value_zero _ x) in E.
  rewrite value_plus, !value_times, opp_IZR, !value_product, Ropp_mult_distr_l_reverse in E.
  pose proof (IZR_le 0 _ (Z.abs_nonneg (hd 0%Z f))) as M.
  assert (0 <= IZR (Z.abs (hd 0%Z f)) * (value (rev s) x * value (rev s) x * value h x))
    by (apply Rmult_le_pos; [exact M | apply Rmult_le_pos; [nra | exact H]]).
  apply Rmult_le_reg_l with (IZR (Z.abs k)); [exact K0 | lra].
Qed.

Lemma over_cosines_enough : forall fuel q p, over_cosines fuel q p = Enough ->
  forall x, -1 <= x < 1 -> 0 <= value q x.
Proof.
  intros fuel q p E x Hx. assert (0 < / (1 - x)) by (apply Rinv_0_lt_compat; lra).
  assert (T : 0 <= (x + 1) / (1 - x)) by (apply Rmult_le_pos; lra).
  apply (mapped_nonneg (-1) 1 1 1 q ((x + 1) / (1 - x))); [field; lra | lra |].
  exact (over_enough _ _ _ _ _ _ E _ T).
Qed.

(** Not below 0 on [-1, 1]. *)
Lemma nonnegative_enough : forall p, nonnegative_on_cosines p = Enough ->
  forall x, -1 <= x <= 1 -> 0 <= value p x.
Proof.
  intros p E x Hx. unfold nonnegative_on_cosines in E.
  destruct (negative_at p 1 1) eqn:N; [discriminate |].
  apply not_negative_at in N; [| reflexivity]. replace (IZR 1 / IZR 1) with 1 in N by field.
  destruct (Rle_lt_or_eq_dec x 1 (proj2 Hx)) as [X | ->]; [| exact N].
  destruct (over_cosines first_halvings p p) eqn:O; try discriminate.
  - exact (over_cosines_enough _ _ _ O x (conj (proj1 Hx) X)).
  - apply (squarefree_enough (length p)). exact (over_cosines_enough _ _ _ E x (conj (proj1 Hx) X)).
Qed.

(** Below 0 somewhere on [-1, 1]. *)
Lemma nonnegative_short : forall p, nonnegative_on_cosines p = Short ->
  exists x, -1 <= x <= 1 /\ value p x < 0.
Proof.
  intros p E. unfold nonnegative_on_cosines in E. destruct (negative_at p 1 1) eqn:N.
  - exists 1. split; [lra |]. replace 1 with (IZR 1 / IZR 1) by field.
    apply negative_at_is; [reflexivity | exact N].
  - assert (O : exists fuel q, over_cosines fuel q p = Short).
    { destruct (over_cosines first_halvings p p) eqn:O; try discriminate;
        do 2 eexists; [exact O | exact E]. }
    destruct O as (fuel & q & O).
    destruct (over_short _ _ _ (-1) 1 1 eq_refl eq_refl O) as (x & Hx & V).
    exists x. split; [lra | exact V].
Qed.
