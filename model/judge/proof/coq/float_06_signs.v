(** docs/error_bounds.md, theorem 6: which signs hold for computed and true values alike. *)
From Coq Require Import Reals Lra Psatz.
From mixcmp Require Import arithmetic.

Open Scope R_scope.

(** A node with the computed value c and the true value x; a zero of either sign counts as both. *)
Definition nonnegative (c x : R) : Prop := 0 <= c /\ 0 <= x.
Definition nonpositive (c x : R) : Prop := c <= 0 /\ x <= 0.

(** "Rounding keeps signs": the rules below are of exact results, and this follows each of them. *)
Theorem rounding_keeps_nonnegative a c x : nonnegative c x -> nonnegative (fl a c) x.
Proof. intros [computed true]. split; auto. now apply fl_nonnegative. Qed.

Theorem rounding_keeps_nonpositive a c x : nonpositive c x -> nonpositive (fl a c) x.
Proof. intros [computed true]. split; auto. now apply fl_nonpositive. Qed.

(** Non-negative: absolutes, squares, square roots; constants >= 0; inputs whose range says so. *)
Theorem absolute_is_nonnegative c x : nonnegative (Rabs c) (Rabs x).
Proof. split; apply Rabs_pos. Qed.

Theorem square_is_nonnegative c x : nonnegative (c ^ 2) (x ^ 2).
Proof. split; apply pow2_ge_0. Qed.

Theorem square_root_is_nonnegative c x : nonnegative (sqrt c) (sqrt x).
Proof. split; apply sqrt_pos. Qed.

Theorem constant_is_nonnegative a v : 0 <= v -> nonnegative (fl a v) v.
Proof. intros. split; auto. now apply fl_nonnegative. Qed.

Theorem constant_is_nonpositive a v : v <= 0 -> nonpositive (fl a v) v.
Proof. intros. split; auto. now apply fl_nonpositive. Qed.

Theorem input_is_nonnegative x : 0 <= x -> nonnegative x x.
Proof. now split. Qed.

Theorem input_is_nonpositive x : x <= 0 -> nonpositive x x.
Proof. now split. Qed.

Section TwoOperands.

Variables (c x c' x' : R).

Ltac operands := unfold nonnegative, nonpositive; intros [] [].

(** Sums, products, quotients, minima of non-negative operands. A divisor 0 is exceptional. *)
Theorem sum_is_nonnegative :
  nonnegative c x -> nonnegative c' x' -> nonnegative (c + c') (x + x').
Proof. operands; split; lra. Qed.

Theorem product_is_nonnegative :
  nonnegative c x -> nonnegative c' x' -> nonnegative (c * c') (x * x').
Proof. operands; split; nra. Qed.

Theorem quotient_is_nonnegative :
  nonnegative c x -> nonnegative c' x' -> c' <> 0 -> x' <> 0 ->
  nonnegative (c / c') (x / x').
Proof.
  operands; intros. split; apply Rmult_le_pos; auto; apply Rlt_le, Rinv_0_lt_compat; lra.
Qed.

Theorem minimum_is_nonnegative :
  nonnegative c x -> nonnegative c' x' -> nonnegative (Rmin c c') (Rmin x x').
Proof. operands; split; now apply Rmin_glb. Qed.

(** A maximum with one non-negative operand. *)
Theorem maximum_is_nonnegative :
  nonnegative c x \/ nonnegative c' x' -> nonnegative (Rmax c c') (Rmax x x').
Proof.
  pose proof (Rmax_l c c'); pose proof (Rmax_r c c').
  pose proof (Rmax_l x x'); pose proof (Rmax_r x x').
  intros [[] | []]; split; lra.
Qed.

(** Products and quotients of two non-positive operands. *)
Theorem product_of_nonpositive_is_nonnegative :
  nonpositive c x -> nonpositive c' x' -> nonnegative (c * c') (x * x').
Proof. operands; split; nra. Qed.

Theorem quotient_of_nonpositive_is_nonnegative :
  nonpositive c x -> nonpositive c' x' -> c' <> 0 -> x' <> 0 ->
  nonnegative (c / c') (x / x').
Proof.
  operands; intros.
  replace (c / c') with (- c / - c') by (field; lra).
  replace (x / x') with (- x / - x') by (field; lra).
  split; apply Rmult_le_pos; try lra; apply Rlt_le, Rinv_0_lt_compat; lra.
Qed.

(** Negated non-positive values. *)
Theorem negated_is_nonnegative : nonpositive c x -> nonnegative (- c) (- x).
Proof. unfold nonnegative, nonpositive. lra. Qed.

(** "Non-positive values: the same rules with signs exchanged." *)
Theorem negated_is_nonpositive : nonnegative c x -> nonpositive (- c) (- x).
Proof. unfold nonnegative, nonpositive. lra. Qed.

Theorem sum_is_nonpositive :
  nonpositive c x -> nonpositive c' x' -> nonpositive (c + c') (x + x').
Proof. operands; split; lra. Qed.

Theorem product_is_nonpositive :
  (nonnegative c x /\ nonpositive c' x') \/ (nonpositive c x /\ nonnegative c' x') ->
  nonpositive (c * c') (x * x').
Proof. intros [[[] []] | [[] []]]; split; nra. Qed.

Theorem quotient_is_nonpositive :
  (nonnegative c x /\ nonpositive c' x') \/ (nonpositive c x /\ nonnegative c' x') ->
  c' <> 0 -> x' <> 0 -> nonpositive (c / c') (x / x').
Proof.
  assert (one : forall p q, q <> 0 -> (0 <= p /\ q <= 0) \/ (p <= 0 /\ 0 <= q) -> p / q <= 0).
  { intros p q nonzero [[p_sign q_sign] | [p_sign q_sign]].
    - replace (p / q) with (- (p * / - q)) by (field; auto).
      assert (0 < / - q) by (apply Rinv_0_lt_compat; lra). nra.
    - assert (0 < / q) by (apply Rinv_0_lt_compat; lra). unfold Rdiv. nra. }
  intros [[[] []] | [[] []]] nonzero nonzero'; split; apply one; auto.
Qed.

Theorem maximum_is_nonpositive :
  nonpositive c x -> nonpositive c' x' -> nonpositive (Rmax c c') (Rmax x x').
Proof. operands; split; now apply Rmax_lub. Qed.

Theorem minimum_is_nonpositive :
  nonpositive c x \/ nonpositive c' x' -> nonpositive (Rmin c c') (Rmin x x').
Proof.
  pose proof (Rmin_l c c'); pose proof (Rmin_r c c').
  pose proof (Rmin_l x x'); pose proof (Rmin_r x x').
  intros [[] | []]; split; lra.
Qed.

(** "Differences are sums with the second operand negated." *)
Theorem difference_is_nonnegative :
  nonnegative c x -> nonpositive c' x' -> nonnegative (c - c') (x - x').
Proof. operands; split; lra. Qed.

Theorem difference_is_nonpositive :
  nonpositive c x -> nonnegative c' x' -> nonpositive (c - c') (x - x').
Proof. operands; split; lra. Qed.

End TwoOperands.
