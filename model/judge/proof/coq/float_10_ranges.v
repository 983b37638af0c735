(** docs/error_bounds.md, theorem 10: the check of a range, intervals of computed values, and
    operations on a grid. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic encodings float_01_one_rounding float_04_last_rounding.

Open Scope R_scope.

Section Checks.

Variable a : arithmetic.
Notation P := (precision a).
Notation number := (number a).
Notation binade := (binade a).

(** Low bits of an encoding that a check does not look at: all but the exponent and three fraction
    bits. *)
Definition unchecked_bits : Z := P - 1 - Z.min 3 (P - 1).
Definition unchecked : Z := 2 ^ unchecked_bits.

Definition leading (key : Z) : Z := key / unchecked.

(** The check of a magnitude: its leading bits are between two constants. *)
Definition passes (least greatest key : Z) : Prop := (least <= leading key <= greatest)%Z.

(** The encodings with these leading bits. *)
Definition first_key (bits : Z) : Z := bits * unchecked.
Definition last_key (bits : Z) : Z := (bits + 1) * unchecked - 1.

Lemma unchecked_positive : (0 < unchecked)%Z.
Proof.
  unfold unchecked. apply Z.pow_pos_nonneg; [lia|]. unfold unchecked_bits.
  pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits. lia.
Qed.

Lemma keys_of_numbers_in_order k k' :
  (0 <= k)%Z -> (0 <= k')%Z -> number k <= number k' -> (k <= k')%Z.
Proof.
  intros whole whole' order. apply Z.nlt_ge. intros less.
  pose proof (number_increases a k' k ltac:(lia)). lra.
Qed.

(** "Every number of the range passes." The ends are rounded into the format. *)
Theorem numbers_of_range_pass low high key_low key_high key :
  (0 <= key_low)%Z -> (0 <= key_high)%Z -> (0 <= key)%Z ->
  number key_low = fl (gradually a) low -> number key_high = fl (gradually a) high ->
  low <= number key <= high ->
  passes (leading key_low) (leading key_high) key.
Proof.
  intros whole_low whole_high whole is_low is_high [above below].
  assert (is_key : fl (gradually a) (number key) = number key).
  { rewrite <- (signed_number_of_nonnegative a key whole). apply number_is_its_own_rounding. }
  apply (fl_keeps_order (gradually a)) in above, below.
  rewrite is_key, <- is_low in above. rewrite is_key, <- is_high in below.
  pose proof unchecked_positive.
  split; apply Z.div_le_mono; auto; now apply keys_of_numbers_in_order.
Qed.

(** "Every number that passes lies in the checked range." *)
Theorem passing_numbers_are_in_checked_range least greatest key :
  (0 <= least)%Z -> (0 <= key)%Z -> passes least greatest key ->
  number (first_key least) <= number key <= number (last_key greatest).
Proof.
  intros whole_least whole [above below]. pose proof unchecked_positive as size.
  unfold leading in *.
  pose proof (Z.div_mod key unchecked). pose proof (Z.mod_pos_bound key unchecked).
  unfold first_key, last_key.
  rewrite <- !V_of_whole.
  split; apply V_does_not_fall; try apply (IZR_le 0); try apply IZR_le; nia.
Qed.

Lemma exponent_bits_are_checked : exists n, (1 <= n <= 8)%Z /\ binade = (n * unchecked)%Z /\
  (n = 8 \/ unchecked = 1)%Z.
Proof.
  pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits.
  unfold binade, unchecked, unchecked_bits.
  destruct (Z.le_gt_cases 4 P) as [long | short].
  - exists 8%Z. rewrite Z.min_l by lia. split; [lia|]. split; [|now left].
    change 8%Z with (2 ^ 3)%Z. rewrite <- Z.pow_add_r by lia. f_equal. lia.
  - exists (2 ^ (P - 1))%Z. rewrite Z.min_r by lia. rewrite Z.sub_diag.
    assert (P = 1 \/ P = 2 \/ P = 3)%Z as [-> | [-> | ->]] by lia; simpl; lia.
Qed.

(** "12.5 % wider at most": of the numbers with the same leading bits as a normal number none is an
    eighth of it away. *)
Theorem checked_range_is_hardly_wider key :
  (binade <= key)%Z ->
  number (last_key (leading key)) <= 9 / 8 * number key /\
  number key <= 9 / 8 * number (first_key (leading key)).
Proof.
  intros normal.
  assert (whole : 0 <= IZR key) by (apply (IZR_le 0); pose proof (binade_positive_Z a); lia).
  pose proof unchecked_positive as size. pose proof (binade_positive_Z a) as B_positive.
  destruct exponent_bits_are_checked as (n & small & is_binade & eight).
  (* the binade of the key: key = i binade + x, with binade <= x < 2 binade *)
  set (i := (key / binade - 1)%Z). set (x := (key - i * binade)%Z).
  pose proof (Z.div_mod key binade). pose proof (Z.mod_pos_bound key binade).
  pose proof (Z.div_le_lower_bound key binade 1).
  assert (i_positive : (0 <= i)%Z) by (unfold i; lia).
  assert (x_inside : (binade <= x < 2 * binade)%Z) by (unfold x, i; lia).
  set (q := (x / unchecked)%Z).
  pose proof (Z.div_mod x unchecked). pose proof (Z.mod_pos_bound x unchecked).
  assert (q_inside : (n <= q < 2 * n)%Z).
  { split; [apply Z.div_le_lower_bound|apply Z.div_lt_upper_bound]; lia. }
  assert (is_leading : leading key = (i * n + q)%Z).
  { unfold leading, q. replace key with (x + i * n * unchecked)%Z by (unfold x; nia).
    rewrite Z.div_add by lia. ring. }
  assert (last : last_key (leading key) = (i * binade + ((q + 1) * unchecked - 1))%Z)
    by (unfold last_key; rewrite is_leading, is_binade; ring).
  assert (first : first_key (leading key) = (i * binade + q * unchecked)%Z)
    by (unfold first_key; rewrite is_leading, is_binade; ring).
  assert (is_key : key = (i * binade + x)%Z) by (unfold x; ring).
  assert (x_is : (q * unchecked <= x < (q + 1) * unchecked)%Z) by (unfold q; nia).
  assert (on_line : forall y, (binade <= y < 2 * binade)%Z ->
            number (i * binade + y) = smallest a * two_to i * IZR y).
  { intros y inside. rewrite (number_on_line a i) by nia. unfold line.
    rewrite plus_IZR, mult_IZR. ring. }
  rewrite last, first, is_key, !on_line by nia.
  assert (scale : 0 < smallest a * two_to i)
    by (apply Rmult_lt_0_compat; [apply smallest_positive|apply bpow_gt_0]).
  assert (upper : (8 * ((q + 1) * unchecked - 1) <= 9 * x)%Z).
  { destruct eight as [eight | one]; [subst n; nia|rewrite one in *; lia]. }
  assert (lower : (8 * x <= 9 * (q * unchecked))%Z).
  { destruct eight as [eight | one]; [subst n; nia|rewrite one in *; lia]. }
  apply IZR_le in upper, lower. rewrite mult_IZR, (mult_IZR 9) in upper, lower.
  split; nra.
Qed.

(** At a subnormal end the range may become nearly twice as wide. *)
Theorem checked_range_of_subnormal_end_is_wider :
  (5 <= P)%Z ->
  let key := unchecked in
  (key < binade)%Z /\ number (last_key (leading key)) >= 3 / 2 * number key.
Proof.
  intros long key. unfold key.
  assert (two_or_more : (2 <= unchecked)%Z).
  { unfold unchecked, unchecked_bits. rewrite Z.min_l by lia.
    change 2%Z with (2 ^ 1)%Z at 1. apply Z.pow_le_mono_r; lia. }
  destruct exponent_bits_are_checked as (n & small & is_binade & [-> | one]); [|lia].
  split; [lia|].
  unfold leading. rewrite Z.div_same by lia. unfold last_key.
  rewrite !(number_on_line a 0) by lia. unfold line.
  pose proof (smallest_positive a). simpl (two_to 0).
  apply Rle_ge. rewrite minus_IZR, mult_IZR. apply (IZR_le 2) in two_or_more. simpl. nra.
Qed.

(** "Rounding is monotone, so an interval rounded outward encloses the computed values." *)
Theorem rounded_interval_encloses l h y :
  l <= y <= h -> fl a l <= fl a y <= fl a h.
Proof. intros []. split; now apply fl_keeps_order. Qed.

(** Overflow is ruled out where neither end overflows. *)
Theorem overflow_ruled_out l h y :
  l <= y <= h ->
  Rabs (rounded a l) < two_to (max_exponent a + 1) ->
  Rabs (rounded a h) < two_to (max_exponent a + 1) ->
  Rabs (rounded a y) < two_to (max_exponent a + 1).
Proof.
  intros [above below] low high.
  apply (rounded_monotone a) in above, below.
  apply Rabs_lt_inv in low, high. apply Rabs_lt. lra.
Qed.

(** Results below the normal range are ruled out where no number of the interval is below it. *)
Theorem underflow_ruled_out l h y :
  l <= y <= h -> two_to (min_exponent a) <= l \/ h <= - two_to (min_exponent a) ->
  ~ below_normal_range a y.
Proof.
  intros [above below] normal. unfold below_normal_range. apply Rle_not_lt.
  apply abs_round_ge_generic; auto with typeclass_instances.
  - apply generic_format_bpow. unfold FLX_exp.
    pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits. lia.
  - pose proof (bpow_gt_0 radix2 (min_exponent a)).
    unfold Rabs. destruct Rcase_abs; destruct normal; lra.
Qed.

(** With both, the operation is not exceptional. *)
Theorem hazards_ruled_out y :
  Rabs (rounded a y) < two_to (max_exponent a + 1) -> ~ below_normal_range a y -> ~ exceptional a y.
Proof. intros small normal [over | (_ & low & _)]; [lra|auto]. Qed.

(** Grids: the multiples of a power of two. *)
Definition on_grid (g : Z) (x : R) : Prop := exists n : Z, x = IZR n * two_to g.

Lemma on_finer_grid g g' x : (g' <= g)%Z -> on_grid g x -> on_grid g' x.
Proof.
  intros finer [n ->]. exists (n * 2 ^ (g - g'))%Z.
  rewrite mult_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by lia.
  rewrite Rmult_assoc, <- bpow_plus. do 2 f_equal. ring.
Qed.

(** "Every sum, product, selection and quotient by a power of two is a multiple of another." *)
Theorem sum_is_on_grid g g' x y :
  on_grid g x -> on_grid g' y -> on_grid (Z.min g g') (x + y).
Proof.
  intros first second.
  apply (on_finer_grid _ (Z.min g g')) in first; [|lia].
  apply (on_finer_grid _ (Z.min g g')) in second; [|lia].
  destruct first as [n ->], second as [n' ->]. exists (n + n')%Z. rewrite plus_IZR. ring.
Qed.

Theorem negated_is_on_grid g x : on_grid g x -> on_grid g (- x).
Proof. intros [n ->]. exists (- n)%Z. rewrite opp_IZR. ring. Qed.

Theorem product_is_on_grid g g' x y : on_grid g x -> on_grid g' y -> on_grid (g + g') (x * y).
Proof.
  intros [n ->] [n' ->]. exists (n * n')%Z. rewrite mult_IZR, bpow_plus. ring.
Qed.

Theorem selection_is_on_grid g g' x y :
  on_grid g x -> on_grid g' y ->
  on_grid (Z.min g g') (Rmin x y) /\ on_grid (Z.min g g') (Rmax x y).
Proof.
  intros first second.
  apply (on_finer_grid _ (Z.min g g')) in first; [|lia].
  apply (on_finer_grid _ (Z.min g g')) in second; [|lia].
  unfold Rmin, Rmax. destruct Rle_dec; auto.
Qed.

Theorem quotient_by_power_is_on_grid g e x : on_grid g x -> on_grid (g - e) (x / two_to e).
Proof.
  intros [n ->]. exists n. unfold Z.sub. rewrite bpow_plus, bpow_opp. unfold Rdiv. ring.
Qed.

(** "If the largest is at most 2^P of these, P digits hold every value." *)
Theorem digits_hold_grid g x : on_grid g x -> Rabs x <= two_to (P + g) -> has_digits a x.
Proof.
  intros [n ->] small.
  pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits.
  assert (short : (Z.abs n <= 2 ^ P)%Z).
  { apply le_IZR. rewrite abs_IZR. change 2%Z with (radix_val radix2).
    rewrite IZR_Zpower by lia. apply (Rmult_le_reg_r (two_to g)); [apply bpow_gt_0|].
    rewrite <- bpow_plus. rewrite Rabs_mult, (Rabs_pos_eq (two_to g)) in small by apply bpow_ge_0.
    exact small. }
  destruct (Z.eq_dec (Z.abs n) (2 ^ P)) as [largest | other].
  - assert (power : has_digits a (two_to (P + g)))
      by (apply generic_format_bpow; unfold FLX_exp; lia).
    assert (is_power : IZR (2 ^ P) * two_to g = two_to (P + g)).
    { change 2%Z with (radix_val radix2). rewrite IZR_Zpower by lia. now rewrite bpow_plus. }
    destruct (Z.abs_eq_or_opp n) as [same | opposite].
    + rewrite <- same, largest, is_power. exact power.
    + replace n with (- 2 ^ P)%Z by lia. rewrite opp_IZR, Ropp_mult_distr_l_reverse, is_power.
      now apply generic_format_opp.
  - apply generic_format_FLX. exists (Float radix2 n g); [reflexivity|].
    cbn [Fnum]. change (radix_val radix2) with 2%Z. lia.
Qed.

(** "And the operation does not round." *)
Theorem grid_operation_rounds_nothing g y :
  on_grid g y -> Rabs y <= two_to (P + g) -> ~ exceptional a y -> fl a y = y.
Proof. intros. apply fl_of_digits_is_exact; auto. now apply digits_hold_grid with g. Qed.

(** "A product has at most the digits of both factors together." *)
Theorem product_has_digits_of_both p q x y :
  (0 <= p)%Z -> (0 <= q)%Z -> of_digits p x -> of_digits q y -> of_digits (p + q) (x * y).
Proof.
  intros p_positive q_positive (f & -> & first) (g & -> & second).
  exists (Float radix2 (Fnum f * Fnum g) (Fexp f + Fexp g)). split.
  - unfold F2R; cbn [Fnum Fexp]. rewrite mult_IZR, bpow_plus. ring.
  - cbn [Fnum]. rewrite Z.abs_mul, Z.pow_add_r by lia. apply Z.mul_lt_mono_nonneg; lia.
Qed.

End Checks.
