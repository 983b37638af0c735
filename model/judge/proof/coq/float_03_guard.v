(** docs/error_bounds.md, theorem 3: a distance of keys with γ(d) > R decides, where R is the
    largest ratio of the true values that equal computed values allow. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic bounds encodings float_02_steps.

Open Scope R_scope.

(** R. *)
Definition largest_ratio (bf bg : interval) : R := Rmax (high bg / low bf) (high bf / low bg).

(** The order of the true values is that of the keys. *)
Definition keys_order (key_f key_g : Z) (true_f true_g : R) : Prop :=
  ((key_f < key_g)%Z -> true_f < true_g) /\
  (key_f = key_g -> true_f = true_g) /\
  ((key_f > key_g)%Z -> true_f > true_g).

Lemma ratio_is_one_or_more bf bg s t :
  0 < low bf -> 0 < low bg -> within bf s -> within bg t -> 1 <= largest_ratio bf bg.
Proof.
  unfold within, largest_ratio. intros f_positive g_positive f_inside g_inside.
  destruct (Rle_lt_dec (low bf) (high bg)) as [above | below].
  - apply Rle_trans with (2 := Rmax_l _ _).
    apply (Rmult_le_reg_r (low bf)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
  - apply Rle_trans with (2 := Rmax_r _ _).
    apply (Rmult_le_reg_r (low bg)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** "R = 1 forces hg <= lf <= hf <= lg, so all four are one number." *)
Lemma ratio_one_forces_one_factor bf bg s t :
  0 < low bf -> 0 < low bg -> within bf s -> within bg t -> largest_ratio bf bg = 1 -> s = t.
Proof.
  unfold within, largest_ratio. intros f_positive g_positive f_inside g_inside one.
  assert (first : high bg / low bf <= 1) by (rewrite <- one; apply Rmax_l).
  assert (second : high bf / low bg <= 1) by (rewrite <- one; apply Rmax_r).
  apply (Rmult_le_compat_r (low bf)) in first; [|lra].
  apply (Rmult_le_compat_r (low bg)) in second; [|lra].
  unfold Rdiv in *. rewrite Rmult_assoc, Rinv_l in first, second by lra. lra.
Qed.

(** "So true f >= lf computed f > hg computed g >= true g", for magnitudes. *)
Lemma larger_magnitude_decides bf bg x y s t :
  0 < low bf -> 0 < low bg -> within bf s -> within bg t -> 0 <= y ->
  largest_ratio bf bg * y < x -> y * t < x * s.
Proof.
  unfold within, largest_ratio. intros f_positive g_positive f_inside g_inside y_positive larger.
  assert (ratio : high bg / low bf * y < x).
  { apply Rle_lt_trans with (2 := larger). apply Rmult_le_compat_r; auto. apply Rmax_l. }
  apply (Rmult_lt_compat_r (low bf)) in ratio; auto.
  replace (high bg / low bf * y * low bf) with (high bg * y) in ratio by (field; lra).
  assert (x_positive : 0 < x).
  { apply Rle_lt_trans with (2 := larger), Rmult_le_pos; auto.
    apply Rle_trans with (2 := Rmax_l _ _), Rlt_le, Rdiv_lt_0_compat; lra. }
  apply Rle_lt_trans with (high bg * y); [nra|].
  apply Rlt_le_trans with (1 := ratio). apply Rmult_le_compat_l; lra.
Qed.

Lemma ratio_is_symmetric bf bg : largest_ratio bf bg = largest_ratio bg bf.
Proof. apply Rmax_comm. Qed.

Section Guard.

Variable a : arithmetic.
Notation P := (precision a).
Notation u := (u a).
Notation V := (V a).
Notation number := (number a).
Notation binade := (binade a).
Notation gamma := (gamma a).
Notation signed_number := (signed_number a).

(** A d that serves theorem 3: every one with γ(d) > R, and 0 if R = 1. *)
Definition serves (d : Z) (R : R) : Prop := (0 <= d)%Z /\ (R < gamma d \/ R = 1).

Section Decision.

Variables (bf bg : interval) (key_f key_g : Z) (true_f true_g : R).
Hypothesis f_bound : relative_bound bf (signed_number key_f) true_f.
Hypothesis g_bound : relative_bound bg (signed_number key_g) true_g.

Lemma greater_key_decides d :
  serves d (largest_ratio bf bg) -> (d <= key_f - key_g)%Z -> (key_f > key_g)%Z ->
  true_f > true_g.
Proof.
  intros [whole guard] distant greater.
  destruct f_bound as (f_positive & s & f_inside & ->).
  destruct g_bound as (g_positive & t & g_inside & ->).
  pose proof (factor_is_positive bf s f_positive f_inside) as s_positive.
  pose proof (factor_is_positive bg t g_positive g_inside) as t_positive.
  destruct guard as [beyond | one].
  2: { rewrite (ratio_one_forces_one_factor bf bg s t) by auto.
       apply Rlt_gt, Rmult_lt_compat_r; auto. apply signed_number_increases. lia. }
  destruct (Z_lt_le_dec key_g 0) as [g_negative | g_whole].
  - destruct (Z_lt_le_dec key_f 0) as [f_negative | f_whole].
    + (* both negative: the magnitudes, with f and g exchanged *)
      apply Rlt_gt. unfold arithmetic.u, encodings.signed_number.
      destruct Z_lt_dec; [|lia]. destruct Z_lt_dec; [|lia].
      assert (number (- key_f) * s < number (- key_g) * t); [|lra].
      apply (larger_magnitude_decides bg bf); auto.
      * apply Rlt_le, number_positive. lia.
      * rewrite ratio_is_symmetric, <- !V_of_whole.
        apply steps_exceed with d; auto.
        -- apply (IZR_le 0). lia.
        -- rewrite V_of_whole. apply number_positive. lia.
        -- rewrite <- plus_IZR. apply IZR_le. lia.
    + pose proof (signed_number_negative a key_g g_negative).
      assert (0 <= signed_number key_f).
      { destruct (Z.eq_dec key_f 0) as [-> | nonzero]; [rewrite signed_number_zero; lra|].
        apply Rlt_le, signed_number_positive. lia. }
      nra.
  - rewrite !signed_number_of_nonnegative by lia.
    assert (f_number_positive : 0 < number key_f) by (apply number_positive; lia).
    apply (larger_magnitude_decides bf bg); auto.
    + destruct (Z.eq_dec key_g 0) as [-> | nonzero]; [rewrite number_zero; lra|].
      apply Rlt_le, number_positive. lia.
    + destruct (Z.eq_dec key_g 0) as [-> | nonzero]; [rewrite number_zero; lra|].
      rewrite <- !V_of_whole. apply steps_exceed with d; auto.
      * apply (IZR_le 0). lia.
      * rewrite V_of_whole. apply number_positive. lia.
      * rewrite <- plus_IZR. apply IZR_le. lia.
Qed.

End Decision.

(** Theorem 3. *)
Theorem distant_keys_decide bf bg key_f key_g true_f true_g d :
  relative_bound bf (signed_number key_f) true_f ->
  relative_bound bg (signed_number key_g) true_g ->
  serves d (largest_ratio bf bg) ->
  (Z.abs (key_f - key_g) >= d)%Z ->
  keys_order key_f key_g true_f true_g.
Proof.
  intros f_bound g_bound guard distant. split; [|split].
  - intros less. apply Rgt_lt.
    apply (greater_key_decides bg bf key_g key_f true_g true_f g_bound f_bound d); try lia.
    now rewrite ratio_is_symmetric.
  - intros same. destruct guard as [whole [beyond | one]].
    + exfalso. assert (d = 0)%Z as -> by lia. rewrite gamma_zero in beyond.
      destruct f_bound as (f_positive & s & f_inside & _).
      destruct g_bound as (g_positive & t & g_inside & _).
      pose proof (ratio_is_one_or_more bf bg s t f_positive g_positive f_inside g_inside). lra.
    + destruct f_bound as (f_positive & s & f_inside & ->).
      destruct g_bound as (g_positive & t & g_inside & ->).
      rewrite (ratio_one_forces_one_factor bf bg s t) by auto. now rewrite same.
  - intros greater.
    apply (greater_key_decides bf bg key_f key_g true_f true_g f_bound g_bound d); auto; lia.
Qed.

(** γ grows: fewer steps multiply by less. *)
Lemma gamma_increases d d' : (0 <= d < d')%Z -> gamma d < gamma d'.
Proof.
  intros [whole less].
  destruct (steps_multiply_no_more a 0 d') as (_ & start & attained); try lia.
  pose proof (Z.mod_pos_bound d' binade (binade_positive_Z a)) as inside.
  set (k2 := ((0 + 2) * binade - d' mod binade)%Z) in *.
  assert (k2_positive : (0 < k2)%Z) by (unfold k2; lia).
  rewrite <- attained. apply Rle_lt_trans with (number (k2 + d) / number k2).
  - rewrite <- !V_of_whole. apply Rge_le, steps_multiply; auto.
    + apply (IZR_le 0). lia.
    + now rewrite V_of_whole.
    + rewrite plus_IZR. lra.
  - apply Rmult_lt_compat_r; [now apply Rinv_0_lt_compat|]. apply number_increases. lia.
Qed.

(** "γ(j 2^(P-1) + r) > R iff r > 2^P (1 - 1/R')", where R = 2^j R'. *)
Theorem gamma_exceeds_ratio_iff j r rest :
  (0 <= j)%Z -> (0 <= r < binade)%Z -> 1 <= rest < 2 ->
  gamma (j * binade + r) > two_to j * rest <-> IZR r > two_to P * (1 - / rest).
Proof.
  intros j_positive [r_positive r_short] [rest_one rest_two].
  unfold float_02_steps.gamma.
  replace ((j * binade + r) / binade)%Z with j by (apply (Z.div_unique _ _ j r); lia).
  replace ((j * binade + r) mod binade)%Z with r by (apply (Z.mod_unique _ _ j r); lia).
  assert (half : 1 / 2 < 1 - IZR r * u <= 1).
  { apply rest_leaves_half. split; [apply (IZR_le 0)|apply IZR_lt]; lia. }
  assert (inverse : two_to P * u = 1)
    by (unfold arithmetic.u; rewrite <- bpow_plus, Z.add_opp_diag_r; reflexivity).
  pose proof (bpow_gt_0 radix2 P) as size. pose proof (bpow_gt_0 radix2 j) as power.
  assert (u_positive : 0 < u) by apply bpow_gt_0.
  assert (rest_inverse : rest * / rest = 1) by (apply Rinv_r; lra).
  unfold gamma_of. split; intros larger.
  - apply Rgt_lt, (Rmult_lt_compat_r (1 - IZR r * u)) in larger; [|lra].
    unfold Rdiv in larger. rewrite (Rmult_assoc (two_to j) (/ _)), Rinv_l in larger by lra.
    assert (rest * (1 - IZR r * u) < 1) by nra.
    assert (1 - IZR r * u < / rest) by (apply (Rmult_lt_reg_l rest); lra).
    nra.
  - assert (1 - IZR r * u < / rest) by nra.
    assert (rest * (1 - IZR r * u) < 1) by (rewrite <- rest_inverse; apply Rmult_lt_compat_l; lra).
    apply Rlt_gt, (Rmult_lt_reg_r (1 - IZR r * u)); [lra|].
    unfold Rdiv. rewrite (Rmult_assoc (two_to j) (/ _)), Rinv_l by lra. nra.
Qed.

(** guard_ulp: "d = j 2^(P-1) + floor(2^P (1 - 1/R')) + 1". *)
Definition guard (j : Z) (rest : R) : Z := j * binade + Zfloor (two_to P * (1 - / rest)) + 1.

(** It is the smallest whole number with γ(d) > R. *)
Theorem guard_is_smallest j rest :
  (0 <= j)%Z -> 1 <= rest < 2 ->
  gamma (guard j rest) > two_to j * rest /\
  forall d, (0 <= d < guard j rest)%Z -> gamma d <= two_to j * rest.
Proof.
  intros j_positive [rest_one rest_two].
  set (steps := two_to P * (1 - / rest)). set (r := Zfloor steps).
  assert (inverse : / rest <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  assert (half : / 2 < / rest) by (apply Rinv_lt_contravar; nra).
  pose proof (bpow_gt_0 radix2 P) as size.
  assert (steps_positive : 0 <= steps) by (unfold steps; nra).
  assert (steps_short : steps < IZR binade).
  { rewrite binade_is_power. unfold steps.
    replace (two_to P) with (2 * two_to (P - 1)) in * by
      (change 2 with (two_to 1); rewrite <- bpow_plus; f_equal; ring).
    nra. }
  pose proof (Zfloor_lb steps) as lower. pose proof (Zfloor_ub steps) as upper.
  fold r in lower, upper.
  assert (r_positive : (0 <= r)%Z) by (apply Zfloor_lub; auto).
  assert (r_short : (r < binade)%Z) by (apply lt_IZR; lra).
  unfold guard. fold steps r. split.
  - destruct (Z.eq_dec (r + 1) binade) as [next | other].
    + replace (j * binade + r + 1)%Z with ((j + 1) * binade + 0)%Z by lia.
      unfold float_02_steps.gamma, gamma_of.
      replace (((j + 1) * binade + 0) / binade)%Z with (j + 1)%Z
        by (apply (Z.div_unique _ _ (j + 1) 0); lia).
      replace (((j + 1) * binade + 0) mod binade)%Z with 0%Z
        by (apply (Z.mod_unique _ _ (j + 1) 0); lia).
      pose proof (bpow_gt_0 radix2 j). rewrite bpow_plus. change (two_to 1) with 2.
      replace (1 - 0 * u) with 1 by ring. unfold Rdiv. rewrite Rinv_1. nra.
    + rewrite <- Z.add_assoc. apply gamma_exceeds_ratio_iff; try lia; try lra.
      fold steps. rewrite plus_IZR. lra.
  - intros d [d_positive below]. apply Rle_trans with (gamma (j * binade + r)).
    + destruct (Z.eq_dec d (j * binade + r)) as [-> | other]; [lra|].
      apply Rlt_le, gamma_increases. lia.
    + apply Rnot_lt_le. intros larger.
      apply gamma_exceeds_ratio_iff in larger; try lia; try lra.
      fold steps in larger. lra.
Qed.

End Guard.
