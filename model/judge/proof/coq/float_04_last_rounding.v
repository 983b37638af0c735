(** docs/error_bounds.md, theorem 4: the last roundings of f and g cost both together one step. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic bounds encodings float_02_steps float_03_guard.

Open Scope R_scope.

Section LastRounding.

Variable a : arithmetic.
Notation P := (precision a).
Notation V := (V a).
Notation number := (number a).
Notation gamma := (gamma a).
Notation signed_number := (signed_number a).
Notation rounded := (rounded a).
Notation fl := (fl a).

(** The sense in which the number with this key is a real number x, rounded: not below the midpoint
    to the lower neighbour, and not above that to the upper one; toward zero, between the number
    and its neighbour. Mirrored for negative numbers; a zero is exact. *)
Definition rounds_magnitude (key : Z) (x : R) : Prop :=
  match mode a with
  | nearest => V (IZR key - 1 / 2) <= x <= V (IZR key + 1 / 2)
  | toward_zero => V (IZR key) <= x < V (IZR key + 1)
  end.

Definition stands_for (key : Z) (x : R) : Prop :=
  if Z.eq_dec key 0 then x = 0
  else if Z_lt_dec 0 key then rounds_magnitude key x
  else rounds_magnitude (- key) (- x).

Lemma stands_for_opposite key x : stands_for key x -> stands_for (- key) (- x).
Proof.
  unfold stands_for. intros stands.
  destruct (Z.eq_dec key 0), (Z.eq_dec (- key) 0); try lia; [lra|].
  destruct (Z_lt_dec 0 key), (Z_lt_dec 0 (- key)); try lia.
  - now rewrite Z.opp_involutive, Ropp_involutive.
  - exact stands.
Qed.

Lemma stands_for_nonnegative key x : (0 <= key)%Z -> stands_for key x -> 0 <= x.
Proof.
  unfold stands_for, rounds_magnitude. intros whole stands.
  destruct (Z.eq_dec key 0); [lra|]. destruct (Z_lt_dec 0 key); [|lia].
  assert (1 <= IZR key) by (apply (IZR_le 1); lia).
  destruct (mode a); [assert (0 <= V (IZR key - 1 / 2)) by (apply V_nonnegative; lra)|
                      assert (0 <= V (IZR key)) by (apply V_nonnegative; lra)]; lra.
Qed.

Lemma stands_for_positive key x : (0 < key)%Z -> stands_for key x -> 0 < x.
Proof.
  unfold stands_for, rounds_magnitude. intros positive stands.
  destruct (Z.eq_dec key 0); [lia|]. destruct (Z_lt_dec 0 key); [|lia].
  assert (1 <= IZR key) by (apply (IZR_le 1); lia).
  destruct (mode a); [assert (0 < V (IZR key - 1 / 2)) by (apply V_positive; lra)|
                      assert (0 < V (IZR key)) by (apply V_positive; lra)]; lra.
Qed.

Lemma stands_for_negative key x : (key < 0)%Z -> stands_for key x -> x < 0.
Proof.
  intros negative stands. apply stands_for_opposite in stands.
  apply stands_for_positive in stands; [lra|lia].
Qed.

(** V half a step up is the midpoint of neighbours. *)
Lemma V_halfway key : (0 <= key)%Z -> V (IZR key + 1 / 2) = (number key + number (key + 1)) / 2.
Proof.
  intros whole. unfold encodings.V.
  replace (Zfloor (IZR key + 1 / 2)) with key; [field|].
  symmetry. apply Zfloor_imp. rewrite plus_IZR. lra.
Qed.

(** "x lies not below the midpoint of f and its lower neighbour": what the rounding of a positive
    exact result shows. *)
Lemma positive_result_stands_for y key :
  (0 < key)%Z -> rounded y = number key -> rounds_magnitude key y.
Proof.
  intros positive is_rounded. unfold rounds_magnitude.
  assert (y_positive : 0 < y).
  { apply Rnot_le_lt. intros not_positive.
    pose proof (rounded_monotone a y 0 not_positive) as below.
    rewrite rounded_zero, is_rounded in below. pose proof (number_positive a key positive). lra. }
  assert (lower : number (key - 1) < number key) by (apply number_increases; lia).
  assert (upper : number key < number (key + 1)) by (apply number_increases; lia).
  assert (digits : forall k, (0 <= k)%Z -> has_digits a (number k))
    by (intros; apply format_has_digits, number_is_of_format; auto).
  destruct (mode a) eqn:is_mode.
  - replace (IZR key - 1 / 2) with (IZR (key - 1) + 1 / 2) by (rewrite minus_IZR; field).
    rewrite !V_halfway by lia. rewrite Z.sub_add.
    pose proof (rounded_is_nearest a y _ is_mode (digits (key - 1)%Z ltac:(lia))) as from_below.
    pose proof (rounded_is_nearest a y _ is_mode (digits (key + 1)%Z ltac:(lia))) as from_above.
    rewrite is_rounded in from_below, from_above.
    unfold Rabs in from_below, from_above. repeat destruct Rcase_abs; lra.
  - rewrite V_of_whole. rewrite <- plus_IZR, V_of_whole.
    pose proof (rounded_toward_zero a y _ is_mode (Rlt_le _ _ y_positive)
                  (digits (key + 1)%Z ltac:(lia))) as [below next].
    rewrite is_rounded in below, next. split; auto.
    apply Rnot_le_lt. intros above. apply next in above. lra.
Qed.

Lemma number_stands_for_itself key : stands_for key (signed_number key).
Proof.
  assert (of_positive : forall k, (0 < k)%Z -> rounds_magnitude k (number k)).
  { intros. apply positive_result_stands_for; auto.
    apply rounded_keeps_digits, format_has_digits, number_is_of_format. lia. }
  unfold stands_for, signed_number.
  destruct (Z.eq_dec key 0) as [-> | nonzero]; [simpl; apply number_zero|].
  destruct (Z_lt_dec 0 key), (Z_lt_dec key 0); try lia; [now apply of_positive|].
  rewrite Ropp_involutive. apply of_positive. lia.
Qed.

(** "f = fl(x)" has this sense for the result of an operation that is not exceptional. *)
Lemma result_stands_for y key : ~ exceptional a y -> fl y = signed_number key -> stands_for key y.
Proof.
  intros ordinary result.
  destruct (not_exceptional_is_exact_or_rounded a y ordinary) as [exact | in_range].
  { rewrite <- exact, result. apply number_stands_for_itself. }
  rewrite result in in_range. unfold stands_for, signed_number in *.
  destruct (Z.eq_dec key 0) as [-> | nonzero].
  - simpl in in_range. rewrite number_zero in in_range.
    now apply eq_0_round_0_FLX with (3 := eq_sym in_range); auto with typeclass_instances.
  - destruct (Z_lt_dec 0 key), (Z_lt_dec key 0); try lia; apply positive_result_stands_for; try lia.
    + auto.
    + rewrite rounded_opposite. lra.
Qed.

Section Decision.

Variables (bf bg : interval) (s t : R).
Hypotheses (f_positive : 0 < low bf) (g_positive : 0 < low bg).
Hypotheses (s_inside : within bf s) (t_inside : within bg t).

(** "In both cases x/y >= γ(key(f) - key(g) - 1) >= γ(d) > R." *)
Lemma distant_magnitudes_exceed key_f key_g x y d R :
  (0 <= key_g)%Z -> (0 <= d)%Z -> R < gamma d -> 0 < R -> (key_f - key_g >= d + 1)%Z ->
  stands_for key_f x -> stands_for key_g y -> R * y < x.
Proof.
  intros g_whole d_whole beyond R_positive distant x_stands y_stands.
  pose proof (stands_for_positive key_f x ltac:(lia) x_stands) as x_positive.
  unfold stands_for, rounds_magnitude in *.
  destruct (Z.eq_dec key_g 0) as [-> | g_nonzero]; [subst; lra|].
  destruct (Z.eq_dec key_f 0); [lia|]. destruct (Z_lt_dec 0 key_f); [|lia].
  destruct (Z_lt_dec 0 key_g) as [g_above|]; [|lia].
  assert (g_one : 1 <= IZR key_g) by (apply (IZR_le 1); lia).
  assert (steps : IZR key_g + 1 + IZR d <= IZR key_f)
    by (rewrite <- !plus_IZR; apply IZR_le; lia).
  destruct (mode a).
  - assert (R * V (IZR key_g + 1 / 2) < V (IZR key_f - 1 / 2)).
    { apply steps_exceed with d; auto; try lra; apply V_positive; lra. }
    nra.
  - assert (R * V (IZR key_g + 1) < V (IZR key_f)).
    { apply steps_exceed with d; auto; try lra; apply V_positive; lra. }
    nra.
Qed.

Lemma greater_rounded_key_decides key_f key_g x y d :
  (0 <= d)%Z -> largest_ratio bf bg < gamma d -> (key_f - key_g >= d + 1)%Z ->
  stands_for key_f x -> stands_for key_g y -> x * s > y * t.
Proof.
  intros whole beyond distant x_stands y_stands.
  pose proof (factor_is_positive bf s f_positive s_inside) as s_positive.
  pose proof (factor_is_positive bg t g_positive t_inside) as t_positive.
  pose proof (ratio_is_one_or_more bf bg s t f_positive g_positive s_inside t_inside) as ratio.
  destruct (Z_lt_le_dec key_g 0) as [g_negative | g_whole].
  - destruct (Z_lt_le_dec 0 key_f) as [f_above | f_below].
    + pose proof (stands_for_positive key_f x f_above x_stands).
      pose proof (stands_for_negative key_g y g_negative y_stands). nra.
    + assert (- x * s < - y * t); [|lra].
      apply (larger_magnitude_decides bg bf); auto.
      * apply (stands_for_nonnegative (- key_f)); [lia|now apply stands_for_opposite].
      * rewrite ratio_is_symmetric.
        apply distant_magnitudes_exceed with (- key_g)%Z (- key_f)%Z d; try lia; try lra;
          now apply stands_for_opposite.
  - apply Rlt_gt, (larger_magnitude_decides bf bg); auto.
    + now apply (stands_for_nonnegative key_g).
    + apply distant_magnitudes_exceed with key_f key_g d; auto; lra.
Qed.

End Decision.

(** Theorem 4, for numbers that stand for real numbers in the sense above: the results of
    operations, and selections. *)
Theorem one_step_more_decides bf bg key_f key_g x y s t d :
  0 < low bf -> 0 < low bg -> within bf s -> within bg t ->
  stands_for key_f x -> stands_for key_g y ->
  (0 <= d)%Z -> gamma d > largest_ratio bf bg ->
  (Z.abs (key_f - key_g) >= d + 1)%Z ->
  keys_order key_f key_g (x * s) (y * t).
Proof.
  intros f_positive g_positive s_inside t_inside x_stands y_stands whole beyond distant.
  split; [|split]; [intros less|intros same; lia|intros greater].
  - apply (greater_rounded_key_decides bg bf t s g_positive f_positive t_inside s_inside
             key_g key_f y x d); auto; try lia.
    now rewrite ratio_is_symmetric.
  - apply (greater_rounded_key_decides bf bg s t f_positive g_positive s_inside t_inside
             key_f key_g x y d); auto; lia.
Qed.

(** The lane's arithmetic with gradual underflow: constants are encoded by it in every lane, and it
    gives each result that is not exceptional. *)
Definition gradually : arithmetic :=
  {| precision := P; min_exponent := min_exponent a; max_exponent := max_exponent a;
     mode := mode a; below_normal := gradual; precision_positive := precision_positive a |}.

Lemma ordinary_result_is_gradual y : ~ exceptional a y -> fl y = arithmetic.fl gradually y.
Proof.
  intros ordinary. destruct (Req_dec y 0) as [-> | nonzero]; [now rewrite !fl_zero|].
  unfold exceptional, below_normal_range, arithmetic.fl in *.
  change (arithmetic.rounded gradually y) with (rounded y).
  change (min_exponent gradually) with (min_exponent a).
  destruct (Rlt_bool_spec (Rabs (rounded y)) (two_to (min_exponent a))) as [low | high].
  - destruct (below_normal a); [exfalso; apply ordinary; auto|reflexivity].
  - reflexivity.
Qed.

(** "If R = 1, one step suffices": f = fl(x) and g = fl(y) themselves. *)
Theorem one_step_decides_equal_factors bf bg key_f key_g x y s t :
  0 < low bf -> 0 < low bg -> within bf s -> within bg t ->
  signed_number key_f = arithmetic.fl gradually x ->
  signed_number key_g = arithmetic.fl gradually y ->
  largest_ratio bf bg = 1 ->
  (Z.abs (key_f - key_g) >= 1)%Z ->
  keys_order key_f key_g (x * s) (y * t).
Proof.
  intros f_positive g_positive s_inside t_inside f_result g_result one distant.
  rewrite (ratio_one_forces_one_factor bf bg s t f_positive g_positive s_inside t_inside one).
  pose proof (factor_is_positive bg t g_positive t_inside) as t_positive.
  assert (ordered : forall k k' z z', signed_number k = arithmetic.fl gradually z ->
            signed_number k' = arithmetic.fl gradually z' -> (k < k')%Z -> z < z').
  { intros k k' z z' first second less. apply Rnot_le_lt. intros above.
    apply (fl_keeps_order gradually) in above.
    pose proof (signed_number_increases a k k' less). lra. }
  split; [|split]; [intros less|intros same; lia|intros greater].
  - apply Rmult_lt_compat_r; auto. now apply (ordered key_f key_g).
  - apply Rmult_lt_compat_r; auto. apply (ordered key_g key_f); auto. lia.
Qed.

(** For R = 1 the sense of [stands_for] would not suffice: to nearest, the midpoint of neighbours
    stands for both, so their keys differ by a step although the true values are equal. *)
Theorem midpoints_need_the_rounding_itself key :
  mode a = nearest -> (0 < key)%Z ->
  exists x, stands_for key x /\ stands_for (key + 1) x.
Proof.
  intros is_nearest positive. exists (V (IZR key + 1 / 2)).
  assert (1 <= IZR key) by (apply (IZR_le 1); lia).
  unfold stands_for, rounds_magnitude. rewrite is_nearest, plus_IZR.
  destruct (Z.eq_dec key 0), (Z.eq_dec (key + 1) 0); try lia.
  destruct (Z_lt_dec 0 key), (Z_lt_dec 0 (key + 1)); try lia.
  replace (IZR key + 1 - 1 / 2) with (IZR key + 1 / 2) by field.
  repeat split; apply V_does_not_fall; lra.
Qed.

(** Selections. "A number of the format, x being the number itself": [number_stands_for_itself];
    and for R = 1: *)
Theorem number_is_its_own_rounding key :
  arithmetic.fl gradually (signed_number key) = signed_number key.
Proof.
  assert (in_format := signed_number_is_of_format a key).
  assert (digits := format_has_digits a _ in_format).
  assert (kept := rounded_keeps_digits gradually (signed_number key) digits).
  unfold arithmetic.fl. rewrite kept. destruct Rlt_bool; auto.
  apply round_generic; auto with typeclass_instances.
Qed.

(** "Of a constant as encoded, to nearest, x being the constant as written". A constant may be
    subnormal and inexact, but not a zero that stands for another number (theorem 5). *)
Theorem constant_stands_for key v :
  mode a = nearest -> signed_number key = arithmetic.fl gradually v -> (key = 0%Z -> v = 0) ->
  stands_for key v.
Proof.
  intros is_nearest encoded zero_is_exact.
  assert (of_positive : forall k w, (0 < k)%Z -> number k = arithmetic.fl gradually w ->
            rounds_magnitude k w).
  { intros k w positive same. unfold rounds_magnitude. rewrite is_nearest.
    assert (lower : number (k - 1) < number k) by (apply number_increases; lia).
    assert (upper : number k < number (k + 1)) by (apply number_increases; lia).
    replace (IZR k - 1 / 2) with (IZR (k - 1) + 1 / 2) by (rewrite minus_IZR; field).
    rewrite !V_halfway by lia. rewrite Z.sub_add.
    assert (closest : forall n, of_format a n ->
              Rabs (arithmetic.fl gradually w - w) <= Rabs (n - w)).
    { intros n in_format. unfold arithmetic.fl. destruct Rlt_bool.
      - unfold to_integer. simpl. rewrite is_nearest.
        apply round_N_pt; auto with typeclass_instances.
      - apply (rounded_is_nearest gradually); auto. now apply format_has_digits. }
    pose proof (closest _ (number_is_of_format a (k - 1) ltac:(lia))) as from_below.
    pose proof (closest _ (number_is_of_format a (k + 1) ltac:(lia))) as from_above.
    rewrite <- same in from_below, from_above.
    unfold Rabs in from_below, from_above. repeat destruct Rcase_abs; lra. }
  unfold stands_for, encodings.signed_number in *.
  destruct (Z.eq_dec key 0); auto.
  destruct (Z_lt_dec 0 key), (Z_lt_dec key 0); try lia; apply of_positive; auto; try lia.
  rewrite fl_opposite. lra.
Qed.

(** Negate and absolute. *)
Theorem absolute_stands_for key x : stands_for key x -> stands_for (Z.abs key) (Rabs x).
Proof.
  intros stands. destruct (Z_lt_le_dec key 0) as [negative | whole].
  - pose proof (stands_for_negative key x negative stands).
    rewrite Rabs_left, Z.abs_neq by lia || lra. now apply stands_for_opposite.
  - pose proof (stands_for_nonnegative key x whole stands).
    now rewrite Rabs_pos_eq, Z.abs_eq.
Qed.

Theorem absolute_of_rounding x : fl (Rabs x) = Rabs (fl x).
Proof.
  unfold Rabs at 1. destruct Rcase_abs as [negative | positive].
  - rewrite fl_opposite, Rabs_left1; auto. apply fl_nonpositive. lra.
  - rewrite Rabs_pos_eq; auto. apply fl_nonnegative. lra.
Qed.

(** Minimum and maximum: "the one with the smaller key has the smaller real number, or both keys are
    equal and either real number will do". *)
Lemma smaller_key_has_smaller_number key_x key_y x y :
  (key_x < key_y)%Z -> stands_for key_x x -> stands_for key_y y -> x <= y.
Proof.
  assert (of_whole : forall k k' z z', (0 <= k < k')%Z ->
            stands_for k z -> stands_for k' z' -> z <= z').
  { intros k k' z z' [whole less] z_stands z'_stands.
    pose proof (stands_for_positive k' z' ltac:(lia) z'_stands).
    unfold stands_for, rounds_magnitude in *.
    destruct (Z.eq_dec k 0); [subst; lra|]. destruct (Z.eq_dec k' 0); [lia|].
    destruct (Z_lt_dec 0 k), (Z_lt_dec 0 k'); try lia.
    assert (1 <= IZR k) by (apply (IZR_le 1); lia).
    assert (IZR k + 1 <= IZR k') by (rewrite <- plus_IZR; apply IZR_le; lia).
    destruct (mode a).
    - assert (V (IZR k + 1 / 2) <= V (IZR k' - 1 / 2)) by (apply V_does_not_fall; lra). lra.
    - assert (V (IZR k + 1) <= V (IZR k')) by (apply V_does_not_fall; lra). lra. }
  intros less x_stands y_stands.
  destruct (Z_lt_le_dec key_x 0) as [x_negative | x_whole].
  - destruct (Z_lt_le_dec 0 key_y) as [y_above | y_below].
    + pose proof (stands_for_negative key_x x x_negative x_stands).
      pose proof (stands_for_positive key_y y y_above y_stands). lra.
    + assert (- y <= - x); [|lra].
      apply (of_whole (- key_y)%Z (- key_x)%Z); try lia; now apply stands_for_opposite.
  - now apply (of_whole key_x key_y).
Qed.

Theorem minimum_stands_for key_x key_y x y :
  stands_for key_x x -> stands_for key_y y -> stands_for (Z.min key_x key_y) (Rmin x y).
Proof.
  intros x_stands y_stands.
  destruct (Z.lt_trichotomy key_x key_y) as [less | [-> | greater]].
  - pose proof (smaller_key_has_smaller_number _ _ _ _ less x_stands y_stands).
    now rewrite Z.min_l, Rmin_left by lia || lra.
  - rewrite Z.min_id. unfold Rmin. destruct Rle_dec; auto.
  - assert (y <= x) by (apply (smaller_key_has_smaller_number key_y key_x); auto; lia).
    now rewrite Z.min_r, Rmin_right by lia || lra.
Qed.

Theorem maximum_stands_for key_x key_y x y :
  stands_for key_x x -> stands_for key_y y -> stands_for (Z.max key_x key_y) (Rmax x y).
Proof.
  intros x_stands y_stands.
  destruct (Z.lt_trichotomy key_x key_y) as [less | [-> | greater]].
  - pose proof (smaller_key_has_smaller_number _ _ _ _ less x_stands y_stands).
    now rewrite Z.max_r, Rmax_right by lia || lra.
  - rewrite Z.max_id. unfold Rmax. destruct Rle_dec; auto.
  - assert (y <= x) by (apply (smaller_key_has_smaller_number key_y key_x); auto; lia).
    now rewrite Z.max_l, Rmax_left by lia || lra.
Qed.

(** "min(fl(x), fl(y)) = fl(min(x, y))", and for maxima. *)
Theorem selection_of_roundings x y :
  Rmin (fl x) (fl y) = fl (Rmin x y) /\ Rmax (fl x) (fl y) = fl (Rmax x y).
Proof.
  destruct (Rle_dec x y) as [order | order].
  - pose proof (fl_keeps_order a x y order).
    now rewrite (Rmin_left x), (Rmax_right x), Rmin_left, Rmax_right.
  - assert (other : y <= x) by lra. pose proof (fl_keeps_order a y x other).
    now rewrite (Rmin_right x), (Rmax_left x), Rmin_right, Rmax_left.
Qed.

End LastRounding.
