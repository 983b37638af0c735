(** docs/error_bounds.md, theorem 7: mixed bounds, x = c t + e with t in an interval and abs(e) at
    most A. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic bounds float_01_one_rounding float_05_rules.

Open Scope R_scope.

Definition mixed_bound (b : interval) (A c x : R) : Prop :=
  0 < low b /\ exists t e, within b t /\ Rabs e <= A /\ x = c * t + e.

(** A mixed bound in which c (t - m) is at most D, as sums that may cancel ask of their operands. *)
Definition mixed_bound_about (m D : R) (b : interval) (A c x : R) : Prop :=
  0 < low b /\ exists t e, within b t /\ Rabs e <= A /\ x = c * t + e /\ Rabs (c * (t - m)) <= D.

Lemma about_is_mixed m D b A c x : mixed_bound_about m D b A c x -> mixed_bound b A c x.
Proof. intros (positive & t & e & inside & small & is_x & _). split; auto. now exists t, e. Qed.

Lemma absolute_part_is_nonnegative b A c x : mixed_bound b A c x -> 0 <= A.
Proof. intros (_ & t & e & _ & small & _). pose proof (Rabs_pos e). lra. Qed.

Lemma Rabs_product_at_most x y X Y : Rabs x <= X -> Rabs y <= Y -> Rabs (x * y) <= X * Y.
Proof. intros. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. Qed.

Lemma Rabs_sum_at_most x y X Y : Rabs x <= X -> Rabs y <= Y -> Rabs (x + y) <= X + Y.
Proof. intros. pose proof (Rabs_triang x y). lra. Qed.

(** "A relative bound is one with A = 0." *)
Theorem relative_is_mixed b c x : relative_bound b c x <-> mixed_bound b 0 c x.
Proof.
  split.
  - intros (positive & t & inside & ->). split; auto. exists t, 0. rewrite Rabs_R0.
    repeat split; auto; try lra; apply inside.
  - intros (positive & t & e & inside & small & ->). split; auto. exists t.
    split; auto. pose proof (Rabs_pos e).
    destruct (Req_dec e 0) as [-> | nonzero]; [ring|].
    pose proof (Rabs_pos_lt e nonzero). lra.
Qed.

(** "The own rounding of an operation multiplies t as in theorem 1 and does not change A." *)
Theorem own_rounding_keeps_absolute_part a b A y x :
  mixed_bound b A y x -> ~ exceptional a y ->
  mixed_bound (product b (rounding_bound a)) A (fl a y) x.
Proof.
  intros (positive & t & e & inside & small & ->) ordinary.
  destruct (one_rounding_within a y ordinary) as (t' & is_y & inside').
  pose proof (rounding_bound_is_positive a).
  split; [now apply product_is_positive|].
  exists (t * t'), e. split; [now apply product_holds|]. split; auto.
  rewrite is_y at 1. ring.
Qed.

(** "A constant that rounds to zero has c = 0, e = v." *)
Theorem constant_zero_rule v : mixed_bound exactly_one (Rabs v) 0 v.
Proof.
  split; [simpl; lra|]. exists 1, v. unfold within; simpl. repeat split; try lra.
Qed.

Section OneOperand.

Variables (b : interval) (A c x : R).
Hypothesis operand : mixed_bound b A c x.

(** Convert: the rule says that the bound passes through. *)
Theorem negate_mixed_rule : mixed_bound b A (- c) (- x).
Proof.
  destruct operand as (positive & t & e & inside & small & ->). split; auto.
  exists t, (- e). rewrite Rabs_Ropp. repeat split; auto; try apply inside. ring.
Qed.

Theorem absolute_mixed_rule : mixed_bound b A (Rabs c) (Rabs x).
Proof.
  destruct operand as (positive & t & e & inside & small & ->). split; auto.
  exists t, (Rabs (c * t + e) - Rabs c * t).
  split; auto. split; [|ring].
  pose proof (factor_is_positive b t positive inside).
  replace (Rabs c * t) with (Rabs (c * t)) by (rewrite Rabs_mult, (Rabs_pos_eq t); lra).
  apply Rle_trans with (2 := small). apply Rle_trans with (1 := Rabs_triang_inv2 _ _).
  right. f_equal. ring.
Qed.

(** Square: A1 (2 h1 abs(a) + A1). *)
Theorem square_mixed_rule :
  mixed_bound {| low := low b ^ 2; high := high b ^ 2 |} (A * (2 * high b * Rabs c + A))
    (c ^ 2) (x ^ 2).
Proof.
  destruct operand as (positive & t & e & inside & small & ->). unfold within in inside.
  split; [simpl; nra|]. exists (t ^ 2), (e * (2 * c * t + e)).
  split; [unfold within; simpl; split; nra|]. split; [|ring].
  apply Rabs_product_at_most; auto. apply Rabs_sum_at_most; auto.
  replace (2 * high b * Rabs c) with (2 * Rabs c * high b) by ring.
  apply Rabs_product_at_most; [|rewrite Rabs_pos_eq; lra].
  rewrite Rabs_mult, (Rabs_pos_eq 2); lra.
Qed.

(** Square root: A1 / sqrt(l1 abs(a)), if A1 <= l1 abs(a) or the true operand is not negative. (For
    a = 0 the lane's bound is infinite, which decides nothing.) *)
Theorem square_root_mixed_rule :
  0 < c -> (A <= low b * Rabs c \/ 0 <= x) ->
  mixed_bound {| low := sqrt (low b); high := sqrt (high b) |} (A / sqrt (low b * Rabs c))
    (sqrt c) (sqrt x) /\ 0 <= x.
Proof.
  intros c_positive condition.
  destruct operand as (positive & t & e & inside & small & is_x). unfold within in inside.
  rewrite (Rabs_pos_eq c) in * by lra.
  assert (least : low b * c <= c * t) by (rewrite Rmult_comm; apply Rmult_le_compat_l; lra).
  assert (least_positive : 0 < low b * c) by now apply Rmult_lt_0_compat.
  assert (x_positive : 0 <= x).
  { destruct condition as [|]; auto. apply Rabs_le_inv in small. lra. }
  split; auto. split; [simpl; now apply sqrt_lt_R0|].
  exists (sqrt t), (sqrt x - sqrt (c * t)).
  split; [unfold within; simpl; split; apply sqrt_le_1; lra|].
  split; [|rewrite sqrt_mult by lra; ring].
  assert (root_least : sqrt (low b * c) <= sqrt (c * t)) by (apply sqrt_le_1; lra).
  assert (root_positive : 0 < sqrt (low b * c)) by now apply sqrt_lt_R0.
  pose proof (sqrt_pos x) as root_x.
  pose proof (sqrt_sqrt x x_positive) as square_x.
  pose proof (sqrt_sqrt (c * t) ltac:(lra)) as square_ct.
  (* the difference of the roots times their sum is e *)
  assert (difference : (sqrt x - sqrt (c * t)) * (sqrt x + sqrt (c * t)) = e) by nra.
  apply (Rmult_le_reg_r (sqrt (low b * c))); auto.
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  apply Rle_trans with (2 := small). rewrite <- difference, Rabs_mult.
  apply Rmult_le_compat_l; [apply Rabs_pos|].
  rewrite Rabs_pos_eq; lra.
Qed.

(** "Else max(abs(a), abs(b)) times the sum of how far the bounds reach from m": for one operand. *)
Definition farthest (b : interval) (m : R) : R := Rmax (high b - m) (m - low b).

Theorem deviation_by_magnitude m : mixed_bound_about m (Rabs c * farthest b m) b A c x.
Proof.
  destruct operand as (positive & t & e & inside & small & is_x). split; auto.
  exists t, e. repeat split; auto; try apply inside.
  apply Rabs_product_at_most; [apply Rle_refl|].
  unfold within in inside. unfold farthest.
  pose proof (Rmax_l (high b - m) (m - low b)). pose proof (Rmax_r (high b - m) (m - low b)).
  apply Rabs_le. lra.
Qed.

End OneOperand.

Section TwoOperands.

Variables (b b' : interval) (A A' c x c' x' : R).
Hypothesis first : mixed_bound b A c x.
Hypothesis second : mixed_bound b' A' c' x'.

Theorem add_equal_signs_mixed_rule :
  (0 <= c /\ 0 <= c') \/ (c <= 0 /\ c' <= 0) ->
  mixed_bound (hull b b') (A + A') (c + c') (x + x').
Proof.
  intros signs.
  destruct first as (positive & s & e & inside & small & ->).
  destruct second as (positive' & t & e' & inside' & small' & ->).
  destruct (add_equal_signs_rule b b' c (c * s) c' (c' * t)) as (both & w & w_inside & is_w); auto.
  - split; auto. now exists s.
  - split; auto. now exists t.
  - split; auto. exists w, (e + e'). split; auto. split; [now apply Rabs_sum_at_most|lra].
Qed.

(** Multiply: h1 abs(a) A2 + A1 A2 + h2 abs(b) A1. *)
Theorem multiply_mixed_rule :
  mixed_bound (product b b')
    (high b * Rabs c * A' + A * A' + high b' * Rabs c' * A) (c * c') (x * x').
Proof.
  destruct first as (positive & s & e & inside & small & ->).
  destruct second as (positive' & t & e' & inside' & small' & ->).
  split; [now apply product_is_positive|].
  exists (s * t), ((c * s + e) * e' + c' * t * e).
  split; [now apply product_holds|]. split; [|ring].
  unfold within in *. apply Rabs_sum_at_most.
  - replace (high b * Rabs c * A' + A * A') with ((Rabs c * high b + A) * A') by ring.
    apply Rabs_product_at_most; auto. apply Rabs_sum_at_most; auto.
    apply Rabs_product_at_most; [lra|rewrite Rabs_pos_eq; lra].
  - replace (high b' * Rabs c' * A) with (Rabs c' * high b' * A) by ring.
    apply Rabs_product_at_most; auto.
    apply Rabs_product_at_most; [lra|rewrite Rabs_pos_eq; lra].
Qed.

(** "x1/x2 - (a/b)(s/t) = (e1 - (a/b)(s/t) e2)/(b t + e2)", for a divisor that is at least k times
    l2 abs(b) in magnitude. *)
Lemma quotient_error s t e e' k :
  within b s -> within b' t -> 0 < low b -> 0 < low b' -> Rabs e <= A -> Rabs e' <= A' ->
  c' <> 0 -> 0 < k -> k * (low b' * Rabs c') <= Rabs (c' * t + e') ->
  Rabs ((c * s + e) / (c' * t + e') - c / c' * (s / t)) <=
    / k * ((A + Rabs (c / c') * A' * high b / low b') / (low b' * Rabs c')).
Proof.
  intros inside inside' positive positive' small small' nonzero k_positive divisor.
  unfold within in *.
  pose proof (Rabs_pos_lt c' nonzero) as c'_positive.
  assert (scale : 0 < low b' * Rabs c') by now apply Rmult_lt_0_compat.
  assert (true_divisor : c' * t + e' <> 0).
  { intros zero. rewrite zero, Rabs_R0 in divisor. nra. }
  replace ((c * s + e) / (c' * t + e') - c / c' * (s / t))
    with ((e - c / c' * (s / t) * e') * / (c' * t + e')) by (field; repeat split; auto; lra).
  replace (/ k * ((A + Rabs (c / c') * A' * high b / low b') / (low b' * Rabs c')))
    with ((A + Rabs (c / c') * (high b / low b') * A') * / (k * (low b' * Rabs c')))
    by (field; repeat split; lra).
  apply Rabs_product_at_most.
  - apply Rabs_sum_at_most; auto. rewrite Rabs_Ropp.
    apply Rabs_product_at_most; auto. apply Rabs_product_at_most; [lra|].
    destruct (quotient_holds b b' s t) as [_ upper]; unfold within; auto.
    rewrite Rabs_pos_eq; [exact upper|]. apply Rlt_le, Rdiv_lt_0_compat; lra.
  - rewrite Rabs_inv. apply Rinv_le_contravar; auto. now apply Rmult_lt_0_compat.
Qed.

(** Divide, A2 = 0. *)
Theorem divide_by_relative_mixed_rule :
  A' = 0 -> c' <> 0 ->
  mixed_bound (quotient b b') (A / (low b' * Rabs c')) (c / c') (x / x').
Proof.
  intros relative nonzero.
  destruct first as (positive & s & e & inside & small & ->).
  destruct second as (positive' & t & e' & inside' & small' & ->).
  split; [now apply quotient_is_positive with t|].
  exists (s / t), ((c * s + e) / (c' * t + e') - c / c' * (s / t)).
  split; [now apply quotient_holds|]. split; [|ring].
  pose proof (quotient_error s t e e' 1) as error.
  replace (A / (low b' * Rabs c'))
    with (/ 1 * ((A + Rabs (c / c') * A' * high b / low b') / (low b' * Rabs c')))
    by (rewrite relative; field; split; [now apply Rabs_no_R0|lra]).
  apply error; auto; [lra|].
  rewrite relative in small'. pose proof (Rabs_pos e').
  assert (e' = 0) as -> by (destruct (Req_dec e' 0) as [|other]; auto;
                            pose proof (Rabs_pos_lt e' other); lra).
  unfold within in *. rewrite Rplus_0_r, Rabs_mult, (Rabs_pos_eq t) by lra.
  pose proof (Rabs_pos c'). nra.
Qed.

(** Divide, if 32 A2 <= l2 abs(b): the true divisor is not 0 then. *)
Theorem divide_mixed_rule :
  32 * A' <= low b' * Rabs c' -> c' <> 0 ->
  mixed_bound (quotient b b')
    (32 / 31 * ((A + Rabs (c / c') * A' * high b / low b') / (low b' * Rabs c')))
    (c / c') (x / x') /\ x' <> 0.
Proof.
  intros condition nonzero.
  destruct first as (positive & s & e & inside & small & ->).
  destruct second as (positive' & t & e' & inside' & small' & ->).
  pose proof (Rabs_pos_lt c' nonzero) as c'_positive.
  assert (divisor : 31 / 32 * (low b' * Rabs c') <= Rabs (c' * t + e')).
  { unfold within in inside'. pose proof (Rabs_triang_inv (c' * t) (- e')) as triangle.
    rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq t) in triangle by lra.
    replace (c' * t - - e') with (c' * t + e') in triangle by ring. nra. }
  split.
  - split; [now apply quotient_is_positive with t|].
    exists (s / t), ((c * s + e) / (c' * t + e') - c / c' * (s / t)).
    split; [now apply quotient_holds|]. split; [|ring].
    replace (32 / 31) with (/ (31 / 32)) by field.
    apply (quotient_error s t e e' (31 / 32)); auto; lra.
  - intros zero. rewrite zero, Rabs_R0 in divisor.
    assert (0 < low b' * Rabs c') by now apply Rmult_lt_0_compat. lra.
Qed.

End TwoOperands.

(** Add of exact a, b (s = t = 1). *)
Theorem add_exact_mixed_rule A A' c x c' x' :
  mixed_bound exactly_one A c x -> mixed_bound exactly_one A' c' x' ->
  mixed_bound exactly_one (A + A') (c + c') (x + x').
Proof.
  intros (_ & s & e & inside & small & ->) (_ & t & e' & inside' & small' & ->).
  unfold within in *; simpl in *. split; [simpl; lra|]. exists 1, (e + e').
  unfold within; simpl. split; [lra|]. split; [now apply Rabs_sum_at_most|].
  replace s with 1 by lra. replace t with 1 by lra. ring.
Qed.

(** Any other add: a s + b t = (a + b) m + a (s - m) + b (t - m). Subtract is add of the negated
    operand. *)
Theorem cancelling_add_mixed_rule m D D' b b' A A' c x c' x' :
  0 < m -> mixed_bound_about m D b A c x -> mixed_bound_about m D' b' A' c' x' ->
  mixed_bound {| low := m; high := m |} (A + A' + D + D') (c + c') (x + x').
Proof.
  intros m_positive (_ & s & e & _ & small & -> & near) (_ & t & e' & _ & small' & -> & near').
  split; [exact m_positive|]. exists m, (e + e' + c * (s - m) + c' * (t - m)).
  unfold within; simpl. split; [lra|]. split; [|ring].
  repeat apply Rabs_sum_at_most; auto.
Qed.

Theorem about_of_negated m D b A c x :
  mixed_bound_about m D b A c x -> mixed_bound_about m D b A (- c) (- x).
Proof.
  intros (positive & t & e & inside & small & -> & near). split; auto. exists t, (- e).
  rewrite Rabs_Ropp. repeat split; auto; try apply inside; [ring|].
  now rewrite Ropp_mult_distr_l_reverse, Rabs_Ropp.
Qed.

Theorem cancelling_subtract_mixed_rule m D D' b b' A A' c x c' x' :
  0 < m -> mixed_bound_about m D b A c x -> mixed_bound_about m D' b' A' c' x' ->
  mixed_bound {| low := m; high := m |} (A + A' + D + D') (c - c') (x - x').
Proof. intros. apply cancelling_add_mixed_rule with b b'; auto. now apply about_of_negated. Qed.

(** Two operands whose deviations both come from their magnitudes: D1 + D2 is at most
    max(abs(a), abs(b)) times the sum of how far both bounds reach from m. *)
Theorem deviations_by_larger_magnitude m b b' c c' :
  0 <= farthest b m -> 0 <= farthest b' m ->
  Rabs c * farthest b m + Rabs c' * farthest b' m <=
    Rmax (Rabs c) (Rabs c') * (farthest b m + farthest b' m).
Proof.
  intros. pose proof (Rmax_l (Rabs c) (Rabs c')). pose proof (Rmax_r (Rabs c) (Rabs c')). nra.
Qed.

(** The power of two at or below a magnitude; 0 for 0. *)
Definition power_at_or_below (c : R) : R :=
  if Req_bool c 0 then 0 else two_to (mag radix2 c - 1).

(** "An operand whose only error is its own rounding, m = 1": half an ulp to nearest, one ulp toward
    zero. For N digits, [a] is the lane's arithmetic with the precision N. *)
Theorem deviation_of_own_rounding a y :
  ~ exceptional a y ->
  mixed_bound_about 1
    (match mode a with
     | nearest => two_to (- precision a)
     | toward_zero => two_to (1 - precision a)
     end * power_at_or_below (fl a y))
    (rounding_bound a) 0 (fl a y) y.
Proof.
  intros ordinary.
  assert (scale_positive : 0 < match mode a with
            nearest => two_to (- precision a) | toward_zero => two_to (1 - precision a) end)
    by (destruct (mode a); apply bpow_gt_0).
  destruct (one_rounding_within a y ordinary) as (t & is_y & inside).
  split; [apply rounding_bound_is_positive|]. exists t, 0. rewrite Rabs_R0.
  repeat split; try apply inside; try lra.
  replace (fl a y * (t - 1)) with (y - fl a y) by lra.
  unfold power_at_or_below. destruct (Req_bool_spec (fl a y) 0) as [zero | nonzero].
  { rewrite zero in *. rewrite is_y at 1. rewrite Rmult_0_l, Rminus_0_r, Rabs_R0. lra. }
  destruct (not_exceptional_is_exact_or_rounded a y ordinary) as [exact | in_range].
  { rewrite exact, Rminus_diag_eq, Rabs_R0 by reflexivity.
    pose proof (bpow_ge_0 radix2 (mag radix2 y - 1)). nra. }
  rewrite in_range in *.
  assert (ulp_of_result : ulp radix2 (FLX_exp (precision a)) (rounded a y) =
            two_to (1 - precision a) * two_to (mag radix2 (rounded a y) - 1)).
  { rewrite ulp_neq_0 by auto. unfold cexp, FLX_exp. rewrite <- bpow_plus. f_equal. ring. }
  rewrite Rabs_minus_sym. destruct (mode a) eqn:is_mode.
  - replace (two_to (- precision a) * two_to (mag radix2 (rounded a y) - 1))
      with (/ 2 * ulp radix2 (FLX_exp (precision a)) (rounded a y)).
    + unfold rounded, to_integer. rewrite is_mode.
      apply error_le_half_ulp_round; auto with typeclass_instances.
    + rewrite ulp_of_result, <- Rmult_assoc. f_equal.
      change (/ 2) with (two_to (-1)). rewrite <- bpow_plus. f_equal. ring.
  - rewrite <- ulp_of_result. apply Rlt_le.
    apply error_lt_ulp_round; auto with typeclass_instances.
    intros zero. apply nonzero. now rewrite zero, rounded_zero.
Qed.

(** Minimum: hull, max(A1, A2). *)
Theorem minimum_mixed_rule b b' A A' c x c' x' :
  mixed_bound b A c x -> mixed_bound b' A' c' x' ->
  mixed_bound (hull b b') (Rmax A A') (Rmin c c') (Rmin x x').
Proof.
  intros (positive & s & e & inside & small & ->) (positive' & t & e' & inside' & small' & ->).
  destruct (minimum_rule b b' c (c * s) c' (c' * t)) as (both & w & w_inside & is_w).
  - split; auto. now exists s.
  - split; auto. now exists t.
  - split; auto. exists w, (Rmin (c * s + e) (c' * t + e') - Rmin (c * s) (c' * t)).
    split; auto. split; [|rewrite is_w; ring].
    pose proof (Rmax_l A A'). pose proof (Rmax_r A A').
    apply Rabs_le_inv in small. apply Rabs_le_inv in small'.
    apply Rabs_le. unfold Rmin. repeat destruct Rle_dec; lra.
Qed.

Theorem maximum_mixed_rule b b' A A' c x c' x' :
  mixed_bound b A c x -> mixed_bound b' A' c' x' ->
  mixed_bound (hull b b') (Rmax A A') (Rmax c c') (Rmax x x').
Proof.
  intros first second.
  rewrite <- (Ropp_involutive (Rmax c c')), <- (Ropp_involutive (Rmax x x')).
  rewrite !Ropp_Rmax. apply negate_mixed_rule, minimum_mixed_rule; now apply negate_mixed_rule.
Qed.

(** "A constant, or a selection among constants and whole operands, m = 1: how far it is off." All
    of them are encoded by one rounding that keeps order and commutes with negation. *)
Section Plain.

Variable encoded : R -> R.
Hypothesis encoding_keeps_order : forall v w, v <= w -> encoded v <= encoded w.
Hypothesis encoding_is_odd : forall v, encoded (- v) = - encoded v.

(** [plain D b A x]: x is such an operand; D is the largest error of those that may be selected. *)
Inductive plain : R -> interval -> R -> R -> Prop :=
| plain_operand x : encoded x = x -> plain 0 exactly_one 0 x
| plain_constant v :
    encoded v <> 0 -> 0 < v / encoded v ->
    plain (Rabs (v - encoded v)) (constant_bound v (encoded v)) 0 v
| plain_constant_zero v : encoded v = 0 -> plain (Rabs v) exactly_one (Rabs v) v
| plain_negate D b A x : plain D b A x -> plain D b A (- x)
| plain_absolute D b A x : plain D b A x -> plain D b A (Rabs x)
| plain_minimum D D' b b' A A' x x' :
    plain D b A x -> plain D' b' A' x' ->
    plain (Rmax D D') (hull b b') (Rmax A A') (Rmin x x')
| plain_maximum D D' b b' A A' x x' :
    plain D b A x -> plain D' b' A' x' ->
    plain (Rmax D D') (hull b b') (Rmax A A') (Rmax x x').

Lemma about_of_wider m D D' b b' A A' c x :
  mixed_bound_about m D b A c x -> 0 < low b' ->
  mixed_bound_about m (Rmax D D') (hull b b') (Rmax A A') c x.
Proof.
  intros (positive & t & e & inside & small & is_x & near) positive'.
  pose proof (Rmax_l D D'). pose proof (Rmax_l A A').
  split; [now apply hull_is_positive|]. exists t, e.
  split; [now apply hull_holds_first|]. repeat split; auto; lra.
Qed.

Theorem deviation_of_plain D b A x : plain D b A x -> mixed_bound_about 1 D b A (encoded x) x.
Proof.
  assert (of_first : forall D D' b b' A A' x, mixed_bound_about 1 D b A (encoded x) x ->
            0 < low b' -> mixed_bound_about 1 (Rmax D D') (hull b b') (Rmax A A')
              (encoded x) x)
    by (intros; now apply about_of_wider).
  assert (of_second : forall D D' b b' A A' x, mixed_bound_about 1 D' b' A' (encoded x) x ->
            0 < low b -> mixed_bound_about 1 (Rmax D D') (hull b b') (Rmax A A') (encoded x) x).
  { intros. rewrite (Rmax_comm D0), (Rmax_comm A0).
    replace (hull b0 b') with (hull b' b0)
      by (unfold hull; f_equal; [apply Rmin_comm|apply Rmax_comm]).
    now apply about_of_wider. }
  induction 1 as [x whole | v nonzero ratio | v zero | D b A x operand IH | D b A x operand IH
                 | D D' b b' A A' x x' first IH second IH'
                 | D D' b b' A A' x x' first IH second IH'].
  - rewrite whole. split; [simpl; lra|]. exists 1, 0. unfold within; simpl.
    rewrite Rminus_diag_eq, Rmult_0_r, Rabs_R0 by reflexivity. repeat split; lra.
  - split; [exact ratio|]. exists (v / encoded v), 0. unfold within; simpl. rewrite Rabs_R0.
    repeat split; try lra; [field; auto|]. right. f_equal. field. auto.
  - rewrite zero. split; [simpl; lra|]. exists 1, v. unfold within; simpl.
    rewrite !Rmult_0_l, Rabs_R0. pose proof (Rabs_pos v). repeat split; lra.
  - rewrite encoding_is_odd. now apply about_of_negated.
  - unfold Rabs. destruct Rcase_abs; auto. rewrite encoding_is_odd. now apply about_of_negated.
  - unfold Rmin. destruct Rle_dec; [apply of_first|apply of_second]; auto; [apply IH'|apply IH].
  - destruct (Rle_dec x x') as [order | order].
    + rewrite (Rmax_right x x') by lra. apply of_second; auto. apply IH.
    + rewrite (Rmax_left x x') by lra. apply of_first; auto. apply IH'.
Qed.

(** The value of a selection is that of the selected encoding. *)
Theorem selection_selects_encodings x x' :
  Rmin (encoded x) (encoded x') = encoded (Rmin x x') /\
  Rmax (encoded x) (encoded x') = encoded (Rmax x x').
Proof.
  destruct (Rle_dec x x') as [order | order].
  - pose proof (encoding_keeps_order x x' order).
    now rewrite (Rmin_left x), (Rmax_right x), Rmin_left, Rmax_right.
  - assert (other : x' <= x) by lra. pose proof (encoding_keeps_order x' x other).
    now rewrite (Rmin_right x), (Rmax_left x), Rmin_right, Rmax_left.
Qed.

End Plain.
