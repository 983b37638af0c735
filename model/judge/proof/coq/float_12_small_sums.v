(** docs/error_bounds.md, theorem 12, with gradual underflow where T is below the smallest normal
    number: multiples of η are added exactly; one product may err by more than η/2. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic encodings float_10_ranges float_12_fused_sums.
Import ListNotations.

Open Scope R_scope.

Section SmallSums.

Variable a : arithmetic.
Notation P := (precision a).
Notation m := (min_exponent a).
Notation fl := (fl a).
Notation eta := (smallest a).
Notation eta_exponent := (m - P + 1)%Z.

Variable terms : list term.
Hypothesis is_nearest : mode a = nearest.
Hypothesis is_gradual : below_normal a = gradual.

Notation T := (magnitudes terms).
Notation s := (exact_sum terms).
Notation S := (cut_sum a terms).
Notation q := (q a terms).

Hypothesis small : T < two_to m.

Lemma largest_exponent_is_least l :
  magnitudes l < two_to m -> largest_exponent (Some m) l = Some m.
Proof.
  induction l as [|t others IH]; intros below; simpl; auto.
  change (magnitudes (t :: others)) with (Rabs (value t) + magnitudes others) in below.
  pose proof (magnitudes_are_nonnegative others). pose proof (Rabs_pos (value t)).
  rewrite IH by lra. destruct (Req_bool_spec (value t) 0) as [zero | nonzero]; auto.
  pose proof (term_reaches_exponent t nonzero).
  assert (exponent t < m)%Z by (apply (lt_bpow radix2); lra).
  f_equal. lia.
Qed.

(** "E = m." *)
Lemma E_is_least : E a terms = m.
Proof. unfold E. rewrite is_gradual. now rewrite largest_exponent_is_least. Qed.

(** "q divides η." *)
Lemma q_divides_half_eta : eta / 2 = two_to (guard_digits terms) * q.
Proof.
  unfold float_12_fused_sums.q, smallest. rewrite E_is_least, <- bpow_plus.
  change (/ 2) with (two_to (-1)). unfold Rdiv. change (/ 2) with (two_to (-1)).
  rewrite <- bpow_plus. f_equal. ring.
Qed.

Lemma guard_is_positive : (0 <= guard_digits terms)%Z.
Proof. unfold guard_digits. pose proof (Z.log2_up_nonneg (Z.of_nat (length terms))). lia. Qed.

Lemma multiple_of_eta_is_multiple_of_q x :
  on_grid eta_exponent x -> exists n : Z, x = IZR n * q.
Proof.
  intros [n ->]. exists (n * 2 ^ (1 + guard_digits terms))%Z. pose proof guard_is_positive.
  rewrite mult_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by lia.
  rewrite (bpow_plus _ 1 (guard_digits terms)). change (two_to 1) with 2.
  change (two_to eta_exponent) with eta. pose proof q_divides_half_eta as half.
  replace eta with (2 * (two_to (guard_digits terms) * q)) by lra. ring.
Qed.

(** "Multiples of η up to 2^(m+1) are numbers of the format": no sum of them is rounded. *)
Theorem multiple_of_eta_is_kept x : on_grid eta_exponent x -> Rabs x <= two_to (m + 1) -> fl x = x.
Proof.
  intros grid below.
  assert (digits : has_digits a x).
  { apply digits_hold_grid with eta_exponent; auto.
    now replace (P + eta_exponent)%Z with (m + 1)%Z by ring. }
  unfold arithmetic.fl. rewrite (rounded_keeps_digits a x digits), is_gradual.
  destruct Rlt_bool; auto. apply round_generic; auto with typeclass_instances.
  destruct grid as [n ->].
  pose proof (precision_positive a) as positive. unfold Prec_gt_0 in positive.
  apply generic_format_FLT_FIX; [exact positive| |].
  - now replace (eta_exponent + P)%Z with (m + 1)%Z by ring.
  - apply generic_format_FIX. now exists (Float radix2 n eta_exponent).
Qed.

Lemma sum_is_at_most_T l : Rabs (exact_sum l) <= magnitudes l.
Proof.
  unfold exact_sum, magnitudes. induction l as [|t others IH]; simpl.
  - rewrite Rabs_R0. lra.
  - apply Rle_trans with (1 := Rabs_triang _ _). fold (sum (map value others)).
    fold (sum (map (fun t => Rabs (value t)) others)). lra.
Qed.

Lemma sum_is_multiple_of_eta l :
  (forall t, In t l -> on_grid eta_exponent (value t)) -> on_grid eta_exponent (exact_sum l).
Proof.
  unfold exact_sum. induction l as [|t others IH]; intros grids.
  - exists 0%Z. simpl. ring.
  - cbn [map sum fold_right]. fold (sum (map value others)).
    replace eta_exponent with (Z.min eta_exponent eta_exponent) by apply Z.min_id.
    apply sum_is_on_grid; [apply grids; now left|]. apply IH. intros. apply grids. now right.
Qed.

(** k = 0: "fused arithmetic is exact". *)
Theorem sum_of_multiples_of_eta_is_exact :
  (forall t, In t terms -> on_grid eta_exponent (value t)) -> fl S = s.
Proof.
  intros grids.
  destruct (sum_without_low_digits_is_exact a terms) as [_ ->].
  { intros t inside. now apply multiple_of_eta_is_multiple_of_q, grids. }
  apply multiple_of_eta_is_kept.
  - now apply sum_is_multiple_of_eta.
  - pose proof (sum_is_at_most_T terms).
    assert (two_to m <= two_to (m + 1)) by (apply bpow_le; lia). lra.
Qed.

(** k = 1: off by less than η/2 + q. *)
Theorem sum_with_one_product_error before product after :
  (2 <= length terms)%nat -> terms = before ++ product :: after ->
  (forall t, In t before \/ In t after -> on_grid eta_exponent (value t)) ->
  Rabs (fl S - s) < eta / 2 + q.
Proof.
  intros two_or_more is_terms grids.
  pose proof (cut_sum_error a terms two_or_more) as [_ smaller].
  assert (cut_only : S - s = cut a terms (value product) - value product).
  { assert (kept : forall l, (forall t, In t l -> on_grid eta_exponent (value t)) ->
              sum (map (fun t => cut a terms (value t)) l) = sum (map value l)).
    { intros l all. f_equal. apply map_ext_in. intros t inside.
      destruct (multiple_of_eta_is_multiple_of_q _ (all t inside)) as [n is_value].
      pose proof (q_is_positive a terms). unfold cut. rewrite is_value.
      replace (IZR n * q / q) with (IZR n) by (field; lra). now rewrite Ztrunc_IZR. }
    assert (split : forall (f : term -> R) l, l = before ++ product :: after ->
              sum (map f l) = sum (map f before) + (f product + sum (map f after))).
    { clear. intros f l ->. induction before as [|t others IH]; simpl.
      - unfold sum. ring.
      - fold (sum (map f (others ++ product :: after))) (sum (map f others)). rewrite IH. ring. }
    unfold cut_sum, exact_sum. rewrite !(split _ terms is_terms).
    rewrite !kept by auto. ring. }
  destruct (cut_loses_less_than_q a terms (value product)) as [near _].
  replace (fl S - s) with ((fl S - S) + (S - s)) by ring. rewrite cut_only.
  apply Rle_lt_trans with (1 := Rabs_triang _ _).
  pose proof (last_rounding a S is_nearest is_gradual) as rounding.
  assert (u_positive : 0 < u a) by apply bpow_gt_0. pose proof (half_eta a).
  assert (Rmax (u a * Rabs S) (eta / 2) <= eta / 2) by (apply Rmax_lub; nra). lra.
Qed.

End SmallSums.

(** "There the excess is real": a product η/2 plus a rest below q, and an even multiple of η. *)
Theorem one_product_may_err_more a x y j rest :
  let terms := [(x, y); (IZR (2 * j) * smallest a, 1)] in
  mode a = nearest -> below_normal a = gradual ->
  magnitudes terms < two_to (min_exponent a) ->
  x * y = smallest a / 2 + rest -> 0 < rest < q a terms ->
  fl a (cut_sum a terms) = IZR (2 * j) * smallest a /\
  Rabs (fl a (cut_sum a terms) - exact_sum terms) > smallest a / 2.
Proof.
  intros terms is_nearest is_gradual small is_product [rest_positive rest_below].
  set (c := IZR (2 * j) * smallest a) in *.
  assert (long : (2 <= length terms)%nat) by (simpl; lia).
  pose proof (smallest_positive a) as eta_positive.
  pose proof (q_divides_half_eta a terms is_gradual small) as half.
  pose proof (q_is_positive a terms) as q_positive.
  assert (whole : IZR (2 ^ guard_digits terms) = two_to (guard_digits terms)).
  { change 2%Z with (radix_val radix2). apply IZR_Zpower, guard_is_positive. }
  assert (product_cut : cut a terms (x * y) = smallest a / 2).
  { unfold cut. replace (Ztrunc (x * y / q a terms)) with (2 ^ guard_digits terms)%Z.
    - rewrite whole. now rewrite half.
    - symmetry. rewrite Ztrunc_floor.
      + apply Zfloor_imp. rewrite plus_IZR, whole, is_product, half.
        replace ((two_to (guard_digits terms) * q a terms + rest) / q a terms)
          with (two_to (guard_digits terms) + rest / q a terms) by (field; lra).
        assert (0 < rest / q a terms < 1); [|lra].
        split; [apply Rdiv_lt_0_compat; lra|].
        apply (Rmult_lt_reg_r (q a terms)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
      + rewrite is_product. apply Rlt_le, Rdiv_lt_0_compat; lra. }
  assert (other_cut : cut a terms (c * 1) = c).
  { rewrite Rmult_1_r.
    destruct (multiple_of_eta_is_multiple_of_q a terms is_gradual small c) as [n is_c].
    - now exists (2 * j)%Z.
    - unfold cut. rewrite is_c.
      replace (IZR n * q a terms / q a terms) with (IZR n) by (field; lra).
      now rewrite Ztrunc_IZR. }
  assert (is_S : cut_sum a terms = (IZR (2 * j) + 1 / 2) * smallest a).
  { unfold cut_sum, terms. cbn [map sum fold_right]. unfold value. cbn [fst snd]. fold terms.
    rewrite product_cut, other_cut. unfold c. field. }
  destruct (cut_sum_error a terms long) as [_ smaller].
  assert (below : Rabs (cut_sum a terms) < two_to (min_exponent a)) by lra.
  assert (digits : has_digits a (cut_sum a terms)).
  { apply digits_hold_grid with (min_exponent a - precision a)%Z.
    - exists (4 * j + 1)%Z. rewrite is_S, plus_IZR, !mult_IZR. unfold smallest.
      rewrite (bpow_plus _ (min_exponent a - precision a) 1). change (two_to 1) with 2. field.
    - replace (precision a + (min_exponent a - precision a))%Z with (min_exponent a) by ring. lra. }
  assert (is_tie : fl a (cut_sum a terms) = c).
  { unfold fl. rewrite (rounded_keeps_digits a _ digits), Rlt_bool_true, is_gradual by exact below.
    unfold round, F2R. cbn [Fnum Fexp]. unfold scaled_mantissa.
    assert (nonzero : cut_sum a terms <> 0).
    { rewrite is_S. intros zero. apply Rmult_integral in zero.
      destruct zero as [zero | zero]; [|lra].
      assert (IZR (4 * j + 1) = 0) as integer by (rewrite plus_IZR, !mult_IZR in *; lra).
      apply eq_IZR in integer. lia. }
    assert (is_exponent : cexp radix2 (FLT_exp (min_exponent a - precision a + 1) (precision a))
              (cut_sum a terms) = (min_exponent a - precision a + 1)%Z).
    { unfold cexp, FLT_exp. pose proof (mag_le_bpow radix2 _ _ nonzero below). lia. }
    rewrite is_exponent, is_S. unfold smallest in *.
    rewrite Rmult_assoc, <- bpow_plus, Z.add_opp_diag_r, Rmult_1_r.
    unfold to_integer. rewrite is_nearest. unfold c. f_equal. f_equal.
    assert (floor : Zfloor (IZR (2 * j) + 1 / 2) = (2 * j)%Z)
      by (apply Zfloor_imp; rewrite plus_IZR; lra).
    unfold Znearest. rewrite floor.
    replace (IZR (2 * j) + 1 / 2 - IZR (2 * j)) with (/ 2) by field.
    rewrite Rcompare_Eq by reflexivity. now rewrite Z.even_mul. }
  split; auto. rewrite is_tie. unfold exact_sum, terms. cbn [map sum fold_right].
  unfold value. cbn [fst snd]. rewrite is_product, Rabs_minus_sym, Rabs_pos_eq; unfold c; lra.
Qed.
