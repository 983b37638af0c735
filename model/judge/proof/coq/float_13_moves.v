(** docs/error_bounds.md, theorem 13: a move keeps the order of the comparison. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.

Open Scope R_scope.

(** The order of x and y is that of x' and y'. *)
Definition same_order (x y x' y' : R) : Prop := Rcompare x y = Rcompare x' y'.

(** The order of x and y is the opposite of that of x' and y'. *)
Definition opposite_order (x y x' y' : R) : Prop := Rcompare x y = Rcompare y' x'.

Lemma same_order_if x y x' y' :
  (x < y -> x' < y') -> (x = y -> x' = y') -> (y < x -> y' < x') -> same_order x y x' y'.
Proof.
  intros below equal above. unfold same_order.
  destruct (Rcompare_spec x y) as [less | same | greater]; symmetry.
  - now apply Rcompare_Lt, below.
  - now apply Rcompare_Eq, equal.
  - now apply Rcompare_Gt, above.
Qed.

Definition strictly_increasing (D : R -> Prop) (h : R -> R) : Prop :=
  forall x y, D x -> D y -> x < y -> h x < h y.

(** [inverse] is the inverse of h on h(D). *)
Definition inverts (D : R -> Prop) (h inverse : R -> R) : Prop :=
  forall x, D x -> inverse (h x) = x.

(** b is in h(D). *)
Definition image (D : R -> Prop) (h : R -> R) (b : R) : Prop := exists z, D z /\ b = h z.

(** Theorem 13: "the order of h(a) and b is that of a and h^-1(b)". *)
Theorem move_keeps_order D h inverse a b :
  strictly_increasing D h -> inverts D h inverse -> D a -> image D h b ->
  same_order (h a) b a (inverse b).
Proof.
  intros increasing inverted inside (z & z_inside & ->). rewrite inverted by auto.
  unfold same_order. symmetry. apply same_order_if.
  - now apply increasing.
  - now intros ->.
  - now apply increasing.
Qed.

(** "h^-1 is strictly increasing on h(D)." *)
Theorem inverse_is_increasing D h inverse :
  strictly_increasing D h -> inverts D h inverse -> strictly_increasing (image D h) inverse.
Proof.
  intros increasing inverted b b' (z & z_inside & ->) (z' & z'_inside & ->) less.
  rewrite !inverted by auto. apply Rnot_le_lt. intros [above | same].
  - pose proof (increasing z' z z'_inside z_inside above). lra.
  - subst z'. lra.
Qed.

(** "With h(a) = sqrt(a), a / c and exp(a), these are the moves to a against b^2, b c and
    log(b)." *)
Theorem root_moves a b : 0 <= a -> 0 <= b -> same_order (sqrt a) b a (b ^ 2).
Proof.
  intros a_sign b_sign.
  apply (move_keeps_order (fun x => 0 <= x) sqrt (fun x => x ^ 2)); auto.
  - intros x y x_sign y_sign less. apply sqrt_lt_1; lra.
  - intros x sign. simpl. rewrite Rmult_1_r. now apply sqrt_sqrt.
  - exists (b ^ 2). split; [apply pow2_ge_0|]. simpl. rewrite Rmult_1_r. now rewrite sqrt_square.
Qed.

Theorem quotient_moves a b c : 0 < c -> same_order (a / c) b a (b * c).
Proof.
  intros positive.
  apply (move_keeps_order (fun _ => True) (fun x => x / c) (fun x => x * c)); auto.
  - intros x y _ _ less. apply Rmult_lt_compat_r; auto. now apply Rinv_0_lt_compat.
  - intros x _. field. lra.
  - exists (b * c). split; auto. field. lra.
Qed.

Theorem exponential_moves a b : 0 < b -> same_order (exp a) b a (ln b).
Proof.
  intros positive.
  apply (move_keeps_order (fun _ => True) exp ln); auto.
  - intros x y _ _ less. now apply exp_increasing.
  - intros x _. apply ln_exp.
  - exists (ln b). split; auto. now rewrite exp_ln.
Qed.

(** "Powers are taken on the numbers from 0 on", with a whole exponent n > 0 here. *)
Theorem powers_increase n : (0 < n)%nat -> strictly_increasing (fun x => 0 <= x) (fun x => x ^ n).
Proof.
  intros positive x y x_sign y_sign less.
  destruct n as [|n]; [inversion positive|]. clear positive.
  induction n as [|n IH]; [simpl; lra|].
  change (x * x ^ Datatypes.S n < y * y ^ Datatypes.S n).
  assert (0 <= x ^ Datatypes.S n) by now apply pow_le. nra.
Qed.

(** "Tan between the poles next to 0." *)
Theorem tangents_increase : strictly_increasing (fun x => - (PI / 2) < x < PI / 2) tan.
Proof. intros x y x_inside y_inside less. apply tan_increasing; lra. Qed.

(** The other steps keep the order as well. *)
Theorem addend_moves u v w : same_order (u + v) w u (w - v).
Proof. apply same_order_if; lra. Qed.

Theorem positive_factor_moves c u w : 0 < c -> same_order (c * u) w u (w / c).
Proof.
  intros positive. assert (is_w : w = c * (w / c)) by (field; lra).
  rewrite is_w at 1. apply same_order_if; nra.
Qed.

(** Two steps reverse it. *)
Theorem negation_reverses u w : opposite_order (- u) w u (- w).
Proof. unfold opposite_order. apply same_order_if; lra. Qed.

Theorem negative_divisor_reverses c u w : c < 0 -> opposite_order (u / c) w u (c * w).
Proof.
  intros negative. assert (is_u : u = c * (u / c)) by (field; lra). unfold opposite_order.
  rewrite is_u at 2. apply same_order_if; nra.
Qed.
