(** docs/error_bounds.md, "The sphere comparison": the guards that theorems 3 and 4 give, and the
    whole lane with the guard 7. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic bounds encodings float_02_steps float_03_guard.
From mixcmp Require Import float_04_last_rounding float_05_rules.
Import ListNotations.

Open Scope R_scope.

Section Guards.

Variable a : arithmetic.
Notation P := (precision a).
Notation u := (u a).
Notation fl := (fl a).

Lemma u_is_at_most k : (k <= P)%Z -> 0 < u <= two_to (- k).
Proof. intros digits. unfold arithmetic.u. split; [apply bpow_gt_0|apply bpow_le; lia]. Qed.

(** A guard is n where 2^P (1 - 1/R) lies from n - 1 to below n. *)
Lemma guard_of_small_ratio rest n :
  IZR n - 1 <= two_to P * (1 - / rest) < IZR n -> guard a 0 rest = n.
Proof.
  intros inside. unfold guard. rewrite (Zfloor_imp (n - 1)); [ring|].
  rewrite minus_IZR. replace (n - 1 + 1)%Z with n by ring. exact inside.
Qed.

Lemma between_steps rest n :
  0 < rest -> (IZR n - 1) * u * rest <= rest - 1 < IZR n * u * rest ->
  IZR n - 1 <= two_to P * (1 - / rest) < IZR n.
Proof.
  intros positive [above below].
  assert (inverse : two_to P * u = 1).
  { unfold arithmetic.u. rewrite <- bpow_plus, Z.add_opp_diag_r. reflexivity. }
  assert (power : 0 < two_to P) by apply bpow_gt_0.
  assert (scale : 0 < two_to P * / rest)
    by (apply Rmult_lt_0_compat; auto; now apply Rinv_0_lt_compat).
  apply (Rmult_le_compat_r (two_to P * / rest)) in above; [|lra].
  apply (Rmult_lt_compat_r (two_to P * / rest)) in below; auto.
  replace ((rest - 1) * (two_to P * / rest)) with (two_to P * (1 - / rest)) in above, below
    by (field; lra).
  replace ((IZR n - 1) * u * rest * (two_to P * / rest))
    with ((IZR n - 1) * (two_to P * u)) in above by (field; lra).
  replace (IZR n * u * rest * (two_to P * / rest)) with (IZR n * (two_to P * u)) in below
    by (field; lra).
  rewrite inverse in above, below. lra.
Qed.

(** "So R = (1+u)^2/(1-u)^4, and 2^P (1 - 1/R) lies between 5 and 6 for every P >= 4: d = 6, and the
    guard is 7." *)
Theorem sphere_guard_before_rounding :
  (4 <= P)%Z -> guard a 0 ((1 + u) ^ 2 / (1 - u) ^ 4) = 6%Z.
Proof.
  intros digits. destruct (u_is_at_most 4 digits) as [positive power].
  assert (small : u <= / 16) by exact power.
  assert (0 < (1 - u) ^ 4) by (apply pow_lt; lra).
  assert (0 < (1 + u) ^ 2) by (apply pow_lt; lra).
  apply guard_of_small_ratio, between_steps; [apply Rdiv_lt_0_compat; lra|].
  replace ((1 + u) ^ 2 / (1 - u) ^ 4 - 1) with (((1 + u) ^ 2 - (1 - u) ^ 4) / (1 - u) ^ 4)
    by (field; lra).
  replace ((6 - 1) * u * ((1 + u) ^ 2 / (1 - u) ^ 4)) with ((5 * u * (1 + u) ^ 2) / (1 - u) ^ 4)
    by (field; lra).
  replace (6 * u * ((1 + u) ^ 2 / (1 - u) ^ 4)) with ((6 * u * (1 + u) ^ 2) / (1 - u) ^ 4)
    by (field; lra).
  assert (0 < / (1 - u) ^ 4) by now apply Rinv_0_lt_compat.
  assert (second : 0 < u ^ 2 <= / 16 * u) by nra.
  assert (third : 0 <= u ^ 3 <= / 16 * u ^ 2) by (simpl; nra).
  assert (fourth : 0 <= u ^ 4 <= / 16 * u ^ 3) by (simpl; nra).
  assert (expanded : (1 + u) ^ 2 - (1 - u) ^ 4 = 6 * u - 5 * u ^ 2 + 4 * u ^ 3 - u ^ 4) by ring.
  rewrite expanded. replace ((1 + u) ^ 2) with (1 + 2 * u + u ^ 2) by ring.
  split.
  - apply Rmult_le_compat_r; [lra|].
    replace (5 * u * (1 + 2 * u + u ^ 2)) with (5 * u + 10 * u ^ 2 + 5 * u ^ 3) by ring. lra.
  - apply Rmult_lt_compat_r; auto.
    replace (6 * u * (1 + 2 * u + u ^ 2)) with (6 * u + 12 * u ^ 2 + 6 * u ^ 3) by ring. lra.
Qed.

(** "Theorem 3 by itself would give 8", from P = 5 on. *)
Theorem sphere_guard_after_rounding :
  (5 <= P)%Z -> guard a 0 ((1 + u) ^ 3 / (1 - u) ^ 5) = 8%Z.
Proof.
  intros digits. destruct (u_is_at_most 5 digits) as [positive power].
  assert (small : u <= / 32) by exact power.
  assert (0 < (1 - u) ^ 5) by (apply pow_lt; lra).
  assert (0 < (1 + u) ^ 3) by (apply pow_lt; lra).
  apply guard_of_small_ratio, between_steps; [apply Rdiv_lt_0_compat; lra|].
  replace ((1 + u) ^ 3 / (1 - u) ^ 5 - 1) with (((1 + u) ^ 3 - (1 - u) ^ 5) / (1 - u) ^ 5)
    by (field; lra).
  replace ((8 - 1) * u * ((1 + u) ^ 3 / (1 - u) ^ 5)) with ((7 * u * (1 + u) ^ 3) / (1 - u) ^ 5)
    by (field; lra).
  replace (8 * u * ((1 + u) ^ 3 / (1 - u) ^ 5)) with ((8 * u * (1 + u) ^ 3) / (1 - u) ^ 5)
    by (field; lra).
  assert (0 < / (1 - u) ^ 5) by now apply Rinv_0_lt_compat.
  assert (second : 0 < u ^ 2 <= / 32 * u) by nra.
  assert (third : 0 <= u ^ 3 <= / 32 * u ^ 2) by (simpl; nra).
  assert (fourth : 0 <= u ^ 4 <= / 32 * u ^ 3) by (simpl; nra).
  assert (fifth : 0 <= u ^ 5 <= / 32 * u ^ 4) by (simpl; nra).
  assert (expanded : (1 + u) ^ 3 - (1 - u) ^ 5 = 8 * u - 7 * u ^ 2 + 11 * u ^ 3 - 5 * u ^ 4 + u ^ 5)
    by ring.
  rewrite expanded. replace ((1 + u) ^ 3) with (1 + 3 * u + 3 * u ^ 2 + u ^ 3) by ring.
  split.
  - apply Rmult_le_compat_r; [lra|].
    replace (7 * u * (1 + 3 * u + 3 * u ^ 2 + u ^ 3))
      with (7 * u + 21 * u ^ 2 + 21 * u ^ 3 + 7 * u ^ 4) by ring. lra.
  - apply Rmult_lt_compat_r; auto.
    replace (8 * u * (1 + 3 * u + 3 * u ^ 2 + u ^ 3))
      with (8 * u + 24 * u ^ 2 + 24 * u ^ 3 + 8 * u ^ 4) by ring. lra.
Qed.

(** "[toward_zero]: 9 from P = 6 on": R = (1+2u)^4, d = 8. *)
Theorem sphere_guard_toward_zero : (6 <= P)%Z -> guard a 0 ((1 + 2 * u) ^ 4) = 8%Z.
Proof.
  intros digits. destruct (u_is_at_most 6 digits) as [positive power].
  assert (small : u <= / 64) by exact power.
  apply guard_of_small_ratio, between_steps; [apply pow_lt; lra|].
  assert (second : 0 < u ^ 2 <= / 64 * u) by nra.
  assert (third : 0 <= u ^ 3 <= / 64 * u ^ 2) by (simpl; nra).
  assert (fourth : 0 <= u ^ 4 <= / 64 * u ^ 3) by (simpl; nra).
  assert (fifth : 0 <= u ^ 5 <= / 64 * u ^ 4) by (simpl; nra).
  replace ((1 + 2 * u) ^ 4) with (1 + 8 * u + 24 * u ^ 2 + 32 * u ^ 3 + 16 * u ^ 4) by ring.
  replace ((8 - 1) * u * (1 + 8 * u + 24 * u ^ 2 + 32 * u ^ 3 + 16 * u ^ 4))
    with (7 * (u + 8 * u ^ 2 + 24 * u ^ 3 + 32 * u ^ 4 + 16 * u ^ 5)) by ring.
  replace (8 * u * (1 + 8 * u + 24 * u ^ 2 + 32 * u ^ 3 + 16 * u ^ 4))
    with (8 * (u + 8 * u ^ 2 + 24 * u ^ 3 + 32 * u ^ 4 + 16 * u ^ 5)) by ring.
  lra.
Qed.

End Guards.

(** The whole lane to nearest, with the guard 7. Operands are any real numbers, taken as they
    are. *)
Section SphereLane.

Variable a : arithmetic.
Notation P := (precision a).
Notation u := (u a).
Notation fl := (fl a).
Hypothesis is_nearest : mode a = nearest.
Hypothesis digits : (4 <= P)%Z.

Variables cxi cxj cyi cyj czi czj ri rj : R.

(** The lane's values. *)
Notation dx := (fl (cxi - cxj)).
Notation dy := (fl (cyi - cyj)).
Notation dz := (fl (czi - czj)).
Notation sx := (fl (dx ^ 2)).
Notation sy := (fl (dy ^ 2)).
Notation sz := (fl (dz ^ 2)).
Notation f := (fl (fl (sx + sy) + sz)).
Notation r := (fl (ri + rj)).
Notation g := (fl (r ^ 2)).

(** No operation is exceptional. *)
Hypothesis ordinary : forall y,
  In y [cxi - cxj; cyi - cyj; czi - czj; dx ^ 2; dy ^ 2; dz ^ 2; sx + sy; fl (sx + sy) + sz;
        ri + rj; r ^ 2] -> ~ exceptional a y.

Notation true_f := ((cxi - cxj) ^ 2 + (cyi - cyj) ^ 2 + (czi - czj) ^ 2).
Notation true_g := ((ri + rj) ^ 2).

Definition power_bound (n : nat) : interval := {| low := (1 - u) ^ n; high := (1 + u) ^ n |}.

Lemma u_is_small : 0 < u <= / 16.
Proof. exact (u_is_at_most a 4 digits). Qed.

Lemma powers_are_positive n : 0 < (1 - u) ^ n /\ 0 < (1 + u) ^ n.
Proof. pose proof u_is_small. split; apply pow_lt; lra. Qed.

Lemma wider_power n k c x :
  (n <= k)%nat -> relative_bound (power_bound n) c x -> relative_bound (power_bound k) c x.
Proof.
  intros order bound. pose proof u_is_small as small.
  apply (widening_rule (power_bound n)); auto; simpl.
  - split; [apply powers_are_positive|].
    replace k with (n + (k - n))%nat by lia. rewrite pow_add.
    pose proof (pow_incr (1 - u) 1 (k - n) ltac:(lra)) as shrinks. rewrite pow1 in shrinks.
    pose proof (powers_are_positive n). nra.
  - apply Rle_pow; lra || lia.
Qed.

Lemma rounding_adds_power n y x :
  relative_bound (power_bound n) y x -> ~ exceptional a y ->
  relative_bound (power_bound (Datatypes.S n)) (fl y) x.
Proof.
  intros bound not_exceptional.
  pose proof (own_rounding_rule a _ y x bound not_exceptional) as rounded.
  unfold rounding_bound in rounded. rewrite is_nearest in rounded.
  apply (widening_rule _ _ _ _ rounded); unfold product; cbn [low high power_bound pow].
  - split; [|lra]. apply (proj1 (powers_are_positive (Datatypes.S n))).
  - lra.
Qed.

Lemma square_doubles_power n c x :
  relative_bound (power_bound n) c x -> relative_bound (power_bound (n * 2)) (c ^ 2) (x ^ 2).
Proof.
  intros bound. pose proof (square_rule _ _ _ bound) as squared.
  unfold power_bound in *. cbn [low high] in squared. now rewrite <- !pow_mult in squared.
Qed.

Lemma operand_sum_is_exact y : relative_bound (power_bound 0) y y.
Proof. apply input_rule. Qed.

Lemma sum_of_squares_keeps_power n c x c' x' :
  0 <= c -> 0 <= c' ->
  relative_bound (power_bound n) c x -> relative_bound (power_bound n) c' x' ->
  relative_bound (power_bound n) (c + c') (x + x').
Proof.
  intros sign sign' first second.
  pose proof (add_equal_signs_rule _ _ _ _ _ _ first second) as sum.
  apply (widening_rule (hull (power_bound n) (power_bound n))).
  - apply sum. left. now split.
  - simpl. rewrite Rmin_left by lra. split; [apply powers_are_positive|lra].
  - simpl. rewrite Rmax_left by lra. lra.
Qed.

Lemma squared_difference_bound p :
  ~ exceptional a p -> ~ exceptional a (fl p ^ 2) ->
  relative_bound (power_bound 3) (fl (fl p ^ 2)) (p ^ 2) /\ 0 <= fl (fl p ^ 2).
Proof.
  intros first second. split; [|apply fl_nonnegative, pow2_ge_0].
  apply (rounding_adds_power 2); auto. apply (square_doubles_power 1).
  apply (rounding_adds_power 0); auto. apply operand_sum_is_exact.
Qed.

(** "The true f is its exact last sum times a number in [(1-u)^4, (1+u)^4]." *)
Lemma true_f_bound : relative_bound (power_bound 4) (fl (sx + sy) + sz) true_f.
Proof.
  destruct (squared_difference_bound (cxi - cxj)) as [x_bound x_sign];
    [apply ordinary; simpl; tauto|apply ordinary; simpl; tauto|].
  destruct (squared_difference_bound (cyi - cyj)) as [y_bound y_sign];
    [apply ordinary; simpl; tauto|apply ordinary; simpl; tauto|].
  destruct (squared_difference_bound (czi - czj)) as [z_bound z_sign];
    [apply ordinary; simpl; tauto|apply ordinary; simpl; tauto|].
  apply sum_of_squares_keeps_power; auto.
  - apply fl_nonnegative. lra.
  - apply (rounding_adds_power 3); [|apply ordinary; simpl; tauto].
    now apply sum_of_squares_keeps_power.
  - now apply (wider_power 3); [lia|].
Qed.

(** "The true g is the exact square of the rounded sum times one in [(1-u)^2, (1+u)^2]." *)
Lemma true_g_bound : relative_bound (power_bound 2) (r ^ 2) true_g.
Proof.
  apply (square_doubles_power 1). apply (rounding_adds_power 0); [apply operand_sum_is_exact|].
  apply ordinary. simpl. tauto.
Qed.

(** R = (1+u)^2/(1-u)^4 is exceeded by 6 steps. *)
Lemma six_steps_exceed_ratio : gamma a 6 > largest_ratio (power_bound 4) (power_bound 2).
Proof.
  pose proof u_is_small as small.
  pose proof (powers_are_positive 4) as fourth. pose proof (powers_are_positive 2) as second.
  replace (largest_ratio (power_bound 4) (power_bound 2)) with ((1 + u) ^ 2 / (1 - u) ^ 4).
  - rewrite <- (sphere_guard_before_rounding a digits).
    assert (ratio : 1 <= (1 + u) ^ 2 / (1 - u) ^ 4 < 2).
    { split; [apply (Rmult_le_reg_r ((1 - u) ^ 4))|apply (Rmult_lt_reg_r ((1 - u) ^ 4))];
        try apply fourth; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      - pose proof (pow_incr (1 - u) 1 4 ltac:(lra)) as shrinks. rewrite pow1 in shrinks. nra.
      - assert ((15 / 16) ^ 4 <= (1 - u) ^ 4) by (apply pow_incr; lra).
        assert ((1 + u) ^ 2 <= (17 / 16) ^ 2) by (apply pow_incr; lra). lra. }
    destruct (guard_is_smallest a 0 _ ltac:(lia) ratio) as [exceeds _].
    simpl (two_to 0) in exceeds. lra.
  - unfold largest_ratio. cbn [low high power_bound]. symmetry. apply Rmax_left.
    apply (Rmult_le_reg_r ((1 - u) ^ 4)); [apply fourth|].
    replace ((1 + u) ^ 2 / (1 - u) ^ 4 * (1 - u) ^ 4) with ((1 + u) ^ 2) by (field; lra).
    replace ((1 + u) ^ 4 / (1 - u) ^ 2 * (1 - u) ^ 4) with ((1 + u) ^ 2 * ((1 + u) * (1 - u)) ^ 2)
      by (field; lra).
    assert (((1 + u) * (1 - u)) ^ 2 <= 1 ^ 2) by (apply pow_incr; nra). nra.
Qed.

(** A lane for spheres that decides from a distance of 7 on is right. *)
Theorem sphere_lane_is_right key_f key_g :
  f = signed_number a key_f -> g = signed_number a key_g ->
  (Z.abs (key_f - key_g) >= 7)%Z ->
  keys_order key_f key_g true_f true_g.
Proof.
  intros is_f is_g distant.
  destruct true_f_bound as (f_positive & s & s_inside & ->).
  destruct true_g_bound as (g_positive & t & t_inside & ->).
  apply (one_step_more_decides a (power_bound 4) (power_bound 2)) with 6%Z; auto; try lia.
  - apply result_stands_for; auto. apply ordinary. simpl. tauto.
  - apply result_stands_for; auto. apply ordinary. simpl. tauto.
  - apply six_steps_exceed_ratio.
Qed.

End SphereLane.
