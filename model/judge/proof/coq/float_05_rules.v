(** docs/error_bounds.md, theorem 5: the relative bound of an operation before its own rounding,
    from those of its operands, and after it. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic bounds float_01_one_rounding.

Open Scope R_scope.

(** Operands are true by definition. *)
Theorem input_rule x : relative_bound exactly_one x x.
Proof. split; [simpl; lra|]. exists 1. unfold within; simpl. lra. Qed.

(** v = c (v/c). *)
Definition constant_bound (v c : R) : interval := {| low := v / c; high := v / c |}.

Theorem constant_rule v c : c <> 0 -> 0 < v / c -> relative_bound (constant_bound v c) c v.
Proof.
  intros nonzero positive. split; [exact positive|]. exists (v / c).
  unfold within, constant_bound; simpl. split; [lra|field; auto].
Qed.

(** The ratio of a constant to its encoding is positive, since rounding keeps signs. *)
Theorem constant_ratio_is_positive a v : fl a v <> 0 -> 0 < v / fl a v.
Proof.
  intros nonzero. destruct (Rtotal_order v 0) as [negative | [-> | positive]].
  - pose proof (fl_nonpositive a v ltac:(lra)).
    replace (v / fl a v) with (- v / - fl a v) by (field; auto). apply Rdiv_lt_0_compat; lra.
  - now rewrite fl_zero in nonzero.
  - pose proof (fl_nonnegative a v ltac:(lra)). apply Rdiv_lt_0_compat; lra.
Qed.

(** A factor t > 0 passes through. *)
Theorem convert_rule b c x : relative_bound b c x -> relative_bound b c x.
Proof. auto. Qed.

Theorem negate_rule b c x : relative_bound b c x -> relative_bound b (- c) (- x).
Proof. apply bound_of_opposite. Qed.

Theorem absolute_rule b c x : relative_bound b c x -> relative_bound b (Rabs c) (Rabs x).
Proof.
  intros (positive & t & inside & ->). split; auto. exists t. split; auto.
  pose proof (factor_is_positive b t positive inside).
  now rewrite Rabs_mult, (Rabs_pos_eq t) by lra.
Qed.

Section Rules.

Variables (b b' : interval) (c x c' x' : R).
Hypothesis first : relative_bound b c x.
Hypothesis second : relative_bound b' c' x'.

(** (a s)(b t) = ab (s t). *)
Theorem multiply_rule : relative_bound (product b b') (c * c') (x * x').
Proof.
  destruct first as (positive & s & inside & ->), second as (positive' & t & inside' & ->).
  split; [now apply product_is_positive|]. exists (s * t).
  split; [now apply product_holds|ring].
Qed.

Theorem square_rule : relative_bound {| low := low b ^ 2; high := high b ^ 2 |} (c ^ 2) (x ^ 2).
Proof.
  destruct first as (positive & s & inside & ->). unfold within in inside.
  split; [simpl; nra|]. exists (s ^ 2). unfold within; simpl. split; [split; nra|ring].
Qed.

(** b = 0 is exceptional. *)
Theorem divide_rule : c' <> 0 -> relative_bound (quotient b b') (c / c') (x / x').
Proof.
  intros nonzero.
  destruct first as (positive & s & inside & ->), second as (positive' & t & inside' & ->).
  pose proof (factor_is_positive b' t positive' inside').
  split; [now apply quotient_is_positive with t|]. exists (s / t).
  split; [now apply quotient_holds|field; lra].
Qed.

(** a < 0 is exceptional. Rounding the ends outward is [widening_rule]. *)
Theorem square_root_rule :
  0 <= c -> relative_bound {| low := sqrt (low b); high := sqrt (high b) |} (sqrt c) (sqrt x).
Proof.
  intros sign. destruct first as (positive & s & inside & ->). unfold within in inside.
  split; [simpl; now apply sqrt_lt_R0|]. exists (sqrt s). unfold within; simpl.
  split; [split; apply sqrt_le_1; lra|apply sqrt_mult; lra].
Qed.

(** a s + b t = (a + b) times a mean of s and t weighted by a, b. *)
Lemma weighted_mean p q s t l h :
  0 <= p -> 0 <= q -> l <= s <= h -> l <= t <= h ->
  exists w, l <= w <= h /\ p * s + q * t = (p + q) * w.
Proof.
  intros p_positive q_positive s_inside t_inside.
  destruct (Req_dec (p + q) 0) as [zero | nonzero].
  - exists s. split; auto. assert (p = 0) as -> by lra. assert (q = 0) as -> by lra. ring.
  - exists ((p * s + q * t) / (p + q)). split; [|field; auto].
    split; apply (Rmult_le_reg_r (p + q)); try lra;
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l by auto; nra.
Qed.

Theorem add_equal_signs_rule :
  (0 <= c /\ 0 <= c') \/ (c <= 0 /\ c' <= 0) ->
  relative_bound (hull b b') (c + c') (x + x').
Proof.
  intros signs.
  destruct first as (positive & s & inside & ->), second as (positive' & t & inside' & ->).
  split; [now apply hull_is_positive|].
  pose proof (hull_holds_first b b' s inside) as s_inside.
  pose proof (hull_holds_second b b' t inside') as t_inside. unfold within in *.
  destruct signs as [[p q] | [p q]].
  - destruct (weighted_mean c c' s t _ _ p q s_inside t_inside) as (w & w_inside & mean).
    now exists w.
  - destruct (weighted_mean (- c) (- c') s t _ _ ltac:(lra) ltac:(lra) s_inside t_inside)
      as (w & w_inside & mean).
    exists w. split; auto. lra.
Qed.

(** Minimum. *)
Lemma minimum_of_ordered : c <= c' -> relative_bound (hull b b') c (Rmin x x').
Proof.
  intros order.
  destruct first as (positive & s & inside & ->), second as (positive' & t & inside' & ->).
  pose proof (factor_is_positive b s positive inside) as s_positive.
  pose proof (factor_is_positive b' t positive' inside') as t_positive.
  split; [now apply hull_is_positive|].
  pose proof (hull_holds_first b b' s inside) as s_inside.
  pose proof (hull_holds_second b b' t inside') as t_inside.
  unfold Rmin. destruct Rle_dec as [smaller | larger]; [now exists s|].
  (* the other operand's true value is smaller: between the multiples of c by t and s *)
  destruct (Req_dec c 0) as [-> | nonzero].
  { exists s. split; auto. assert (c' * t >= 0) by (apply Rle_ge, Rmult_le_pos; lra). lra. }
  exists (c' * t / c). split; [|field; auto].
  destruct (Rlt_le_dec c 0) as [negative | above].
  - (* c <= c', c' t < c s: then c' < 0 as well *)
    assert (c' < 0) by nra. unfold within in *.
    split; apply Rnot_lt_le; intros outside;
      apply (Rmult_lt_compat_r (- c)) in outside; try lra;
      replace (c' * t / c * - c) with (- (c' * t)) in outside by (field; lra); nra.
  - unfold within in *.
    split; apply Rnot_lt_le; intros outside;
      apply (Rmult_lt_compat_r c) in outside; try lra;
      replace (c' * t / c * c) with (c' * t) in outside by (field; lra); nra.
Qed.

End Rules.

Theorem minimum_rule b b' c x c' x' :
  relative_bound b c x -> relative_bound b' c' x' ->
  relative_bound (hull b b') (Rmin c c') (Rmin x x').
Proof.
  intros first second. unfold Rmin at 1. destruct Rle_dec as [order | other].
  - now apply minimum_of_ordered with c'.
  - replace (hull b b') with (hull b' b)
      by (unfold hull; f_equal; [apply Rmin_comm|apply Rmax_comm]).
    rewrite Rmin_comm. apply minimum_of_ordered with c; auto. lra.
Qed.

(** Maximum by negation. *)
Theorem maximum_rule b b' c x c' x' :
  relative_bound b c x -> relative_bound b' c' x' ->
  relative_bound (hull b b') (Rmax c c') (Rmax x x').
Proof.
  intros first second.
  rewrite <- (Ropp_involutive (Rmax c c')), <- (Ropp_involutive (Rmax x x')).
  rewrite !Ropp_Rmax. apply negate_rule, minimum_rule; now apply negate_rule.
Qed.

(** Both bounds are [1, 1]: y is the true result. *)
Theorem add_exact_rule c x c' x' :
  relative_bound exactly_one c x -> relative_bound exactly_one c' x' ->
  relative_bound exactly_one (c + c') (x + x').
Proof.
  intros (_ & s & inside & ->) (_ & t & inside' & ->). unfold within in *; simpl in *.
  replace s with 1 by lra. replace t with 1 by lra. rewrite !Rmult_1_r. apply input_rule.
Qed.

(** Subtract is add of the negated operand. *)
Theorem subtract_exact_rule c x c' x' :
  relative_bound exactly_one c x -> relative_bound exactly_one c' x' ->
  relative_bound exactly_one (c - c') (x - x').
Proof. intros. apply add_exact_rule; auto. now apply negate_rule. Qed.

Theorem subtract_equal_signs_rule b b' c x c' x' :
  relative_bound b c x -> relative_bound b' c' x' ->
  (0 <= c /\ c' <= 0) \/ (c <= 0 /\ 0 <= c') ->
  relative_bound (hull b b') (c - c') (x - x').
Proof. intros. apply add_equal_signs_rule; auto; [now apply negate_rule|lra]. Qed.

(** Rounding an end outward keeps a bound a bound. *)
Theorem widening_rule b b' c x :
  relative_bound b c x -> 0 < low b' <= low b -> high b <= high b' -> relative_bound b' c x.
Proof.
  intros (positive & t & inside & ->) lower upper. unfold within in *.
  split; [lra|]. exists t. unfold within. split; [lra|auto].
Qed.

Lemma rounding_bound_is_positive a : 0 < low (rounding_bound a).
Proof.
  unfold rounding_bound. destruct (mode a); simpl; [|lra].
  assert (u a < 1); [|lra]. unfold u. change 1 with (two_to 0). apply bpow_lt.
  pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits. lia.
Qed.

(** "And times the interval of theorem 1 after the operation's own rounding." *)
Theorem own_rounding_rule a b y x :
  relative_bound b y x -> ~ exceptional a y ->
  relative_bound (product b (rounding_bound a)) (fl a y) x.
Proof.
  intros (positive & t & inside & ->) ordinary.
  destruct (one_rounding_within a y ordinary) as (t' & is_y & inside').
  split; [apply product_is_positive; auto; apply rounding_bound_is_positive|].
  exists (t * t'). split.
  - apply product_holds; auto. apply rounding_bound_is_positive.
  - rewrite is_y at 1. ring.
Qed.

(** The rules together: what the analysis derives for a node with the computed value c and the true
    value x. Each rounding may be to any number of digits, as conversions of operands are. *)
Inductive derived : interval -> R -> R -> Prop :=
| derived_input x : derived exactly_one x x
| derived_constant v c : c <> 0 -> 0 < v / c -> derived (constant_bound v c) c v
| derived_negate b c x : derived b c x -> derived b (- c) (- x)
| derived_absolute b c x : derived b c x -> derived b (Rabs c) (Rabs x)
| derived_multiply b b' c x c' x' :
    derived b c x -> derived b' c' x' -> derived (product b b') (c * c') (x * x')
| derived_square b c x :
    derived b c x -> derived {| low := low b ^ 2; high := high b ^ 2 |} (c ^ 2) (x ^ 2)
| derived_divide b b' c x c' x' :
    derived b c x -> derived b' c' x' -> c' <> 0 -> derived (quotient b b') (c / c') (x / x')
| derived_square_root b c x :
    derived b c x -> 0 <= c ->
    derived {| low := sqrt (low b); high := sqrt (high b) |} (sqrt c) (sqrt x)
| derived_add_equal_signs b b' c x c' x' :
    derived b c x -> derived b' c' x' -> (0 <= c /\ 0 <= c') \/ (c <= 0 /\ c' <= 0) ->
    derived (hull b b') (c + c') (x + x')
| derived_add_exact c x c' x' :
    derived exactly_one c x -> derived exactly_one c' x' -> derived exactly_one (c + c') (x + x')
| derived_minimum b b' c x c' x' :
    derived b c x -> derived b' c' x' -> derived (hull b b') (Rmin c c') (Rmin x x')
| derived_maximum b b' c x c' x' :
    derived b c x -> derived b' c' x' -> derived (hull b b') (Rmax c c') (Rmax x x')
| derived_widened b b' c x :
    derived b c x -> 0 < low b' <= low b -> high b <= high b' -> derived b' c x
| derived_rounded a b y x :
    derived b y x -> ~ exceptional a y -> derived (product b (rounding_bound a)) (fl a y) x.

(** Theorem 5. *)
Theorem derived_bounds_hold b c x : derived b c x -> relative_bound b c x.
Proof.
  induction 1.
  - apply input_rule.
  - now apply constant_rule.
  - now apply negate_rule.
  - now apply absolute_rule.
  - now apply multiply_rule.
  - now apply square_rule.
  - now apply divide_rule.
  - now apply square_root_rule.
  - now apply add_equal_signs_rule.
  - now apply add_exact_rule.
  - now apply minimum_rule.
  - now apply maximum_rule.
  - now apply widening_rule with b.
  - now apply own_rounding_rule.
Qed.
