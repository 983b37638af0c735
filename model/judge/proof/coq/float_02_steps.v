(** docs/error_bounds.md, theorem 2: a step of d encodings up from a positive number multiplies it
    by at least γ(d) = 2^j / (1 - r u), where d = j 2^(P-1) + r. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic encodings.

Open Scope R_scope.

Section Steps.

Variable a : arithmetic.
Notation P := (precision a).
Notation u := (u a).
Notation V := (V a).
Notation number := (number a).
Notation binade := (binade a).

(** γ of a distance j 2^(P-1) + r. *)
Definition gamma_of (j : Z) (r : R) : R := two_to j / (1 - r * u).

(** γ of a whole distance. *)
Definition gamma (d : Z) : R := gamma_of (d / binade) (IZR (d mod binade)).

Lemma rest_leaves_half r : 0 <= r < IZR binade -> 1 / 2 < 1 - r * u <= 1.
Proof.
  intros [above below]. pose proof (two_binades_u a) as unit.
  assert (0 < u) by apply bpow_gt_0. nra.
Qed.

(** V(k2) is on the line of its binade, V(k2 + d) is above the lines j and j + 1 binades up. Of
    these, the first proves the ratio where r steps do not leave the binade, the second elsewhere.
    (The page derives the same by the sign of a derivative.) *)
Theorem steps_multiply_real k1 k2 j r :
  0 <= k2 -> 0 < V k2 ->
  (0 <= j)%Z -> 0 <= r < IZR binade ->
  k1 >= k2 + (IZR j * IZR binade + r) ->
  V k1 / V k2 >= gamma_of j r.
Proof.
  intros k2_positive V_k2_positive j_positive [r_positive r_short] distant.
  pose proof (rest_leaves_half r (conj r_positive r_short)) as rest.
  pose proof (two_binades_u a) as unit. pose proof (binade_positive a) as size.
  set (B := IZR binade) in *.
  assert (j_real : 0 <= IZR j) by now apply (IZR_le 0).
  apply Rle_ge. apply (Rmult_le_reg_r (V k2)); auto.
  unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  apply Rle_trans with (V (k2 + (IZR j * B + r))); [|apply V_does_not_fall; nra].
  set (k := k2 + (IZR j * B + r)).
  destruct (V_has_line a k2 k2_positive) as (i & i_positive & on_line & [above below] & _ & _).
  fold B in above, below. set (x := k2 - IZR i * B) in *.
  assert (first : line a (i + j) k <= V k) by (apply V_above_line; [lia|unfold k; nra]).
  assert (second : line a (i + j + 1) k <= V k) by (apply V_above_line; [lia|unfold k; nra]).
  rewrite on_line. unfold line in *. fold B in first, second |- *. fold x.
  set (scale := smallest a * two_to i).
  assert (scale_positive : 0 < scale)
    by (apply Rmult_lt_0_compat; [apply smallest_positive|apply bpow_gt_0]).
  replace (smallest a * two_to (i + j) * (k - IZR (i + j) * B))
    with (scale * two_to j * (x + r)) in first
    by (unfold scale, x, k; rewrite bpow_plus, plus_IZR; ring).
  replace (smallest a * two_to (i + j + 1) * (k - IZR (i + j + 1) * B))
    with (scale * two_to j * (2 * (x + r - B))) in second
    by (unfold scale, x, k; rewrite !bpow_plus, !plus_IZR; change (two_to 1) with 2; ring).
  unfold gamma_of.
  assert (enough : forall y, x <= y * (1 - r * u) -> scale * two_to j * y <= V k ->
                     two_to j / (1 - r * u) * (scale * x) <= V k).
  { intros y large below_V. apply Rle_trans with (2 := below_V).
    replace (two_to j / (1 - r * u) * (scale * x))
      with (scale * two_to j * (x / (1 - r * u))) by (field; lra).
    apply Rmult_le_compat_l.
    - apply Rmult_le_pos; [lra|apply bpow_ge_0].
    - apply (Rmult_le_reg_r (1 - r * u)); [lra|].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r; lra. }
  assert (u_size : u = / (2 * B)) by (apply Rmult_eq_reg_l with (2 * B); [rewrite Rinv_r|]; lra).
  destruct (Rle_lt_dec (x + r) (2 * B)) as [stays | crosses].
  - apply enough with (2 := first). rewrite u_size.
    apply (Rmult_le_reg_r (2 * B)); [lra|].
    replace ((x + r) * (1 - r * / (2 * B)) * (2 * B)) with ((x + r) * (2 * B - r)) by (field; lra).
    nra.
  - apply enough with (2 := second). rewrite u_size.
    apply (Rmult_le_reg_r (2 * B)); [lra|].
    replace (2 * (x + r - B) * (1 - r * / (2 * B)) * (2 * B))
      with (2 * (x + r - B) * (2 * B - r)) by (field; lra).
    (* with s = x + r - 2 B >= 0 the difference is 2 s (B - r) *)
    nra.
Qed.

(** Theorem 2 for a whole d, as the guards use it; k1 and k2 are real. *)
Theorem steps_multiply k1 k2 d :
  0 <= k2 -> 0 < V k2 -> (0 <= d)%Z -> k1 >= k2 + IZR d -> V k1 / V k2 >= gamma d.
Proof.
  intros k2_positive V_k2_positive whole distant.
  pose proof (binade_positive_Z a) as size.
  pose proof (Z.mod_pos_bound d binade size) as inside.
  apply steps_multiply_real; auto.
  - now apply Z.div_pos.
  - split; [apply (IZR_le 0)|apply IZR_lt]; lia.
  - rewrite <- mult_IZR, <- plus_IZR.
    replace (d / binade * binade + d mod binade)%Z with d; auto.
    rewrite (Z.div_mod d binade) at 1; lia.
Qed.

(** "The bound is attained: k2 the encoding r steps below a power of two", 2^i times the second
    normal binade's smallest number. *)
Theorem steps_multiply_no_more i d :
  (0 <= i)%Z -> (0 <= d)%Z ->
  let k2 := ((i + 2) * binade - d mod binade)%Z in
  number ((i + 2) * binade) = two_to (i + 1 + min_exponent a) /\
  0 < number k2 /\ number (k2 + d) / number k2 = gamma d.
Proof.
  intros at_least whole k2.
  pose proof (binade_positive_Z a) as size. pose proof (binade_positive a) as real_size.
  pose proof (Z.mod_pos_bound d binade size) as inside.
  pose proof (Z.div_mod d binade) as parts. pose proof (Z.div_pos d binade whole size).
  set (j := (d / binade)%Z) in *. set (r := (d mod binade)%Z) in *.
  assert (start : number k2 = smallest a * two_to i * (2 * IZR binade - IZR r)).
  { rewrite (number_on_line a i) by (unfold k2; nia). unfold line, k2.
    rewrite minus_IZR, mult_IZR, plus_IZR. ring. }
  assert (ended : number (k2 + d) = smallest a * two_to i * two_to j * (2 * IZR binade)).
  { replace (k2 + d)%Z with ((i + j + 2) * binade)%Z by (unfold k2; lia).
    rewrite (number_on_line a (i + j)) by nia. unfold line.
    rewrite mult_IZR, !plus_IZR, bpow_plus. ring. }
  pose proof (smallest_positive a). pose proof (bpow_gt_0 radix2 i) as power.
  assert (short : IZR r < IZR binade) by (apply IZR_lt; lia).
  split; [|split].
  - rewrite (number_on_line a i) by nia. unfold line.
    replace (IZR ((i + 2) * binade) - IZR i * IZR binade) with (2 * IZR binade)
      by (rewrite mult_IZR, plus_IZR; ring).
    rewrite binade_is_power. unfold smallest. change 2 with (two_to 1). rewrite <- !bpow_plus.
    f_equal. ring.
  - rewrite start. apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
  - rewrite start, ended. unfold gamma, gamma_of. fold j r.
    pose proof (two_binades_u a) as unit.
    assert (u_size : u = / (2 * IZR binade))
      by (apply Rmult_eq_reg_l with (2 * IZR binade); [rewrite Rinv_r|]; lra).
    rewrite u_size. field. lra.
Qed.

(** Steps with γ(d) > R multiply by more than R. *)
Lemma steps_exceed R k1 k2 d :
  0 <= k2 -> 0 < V k2 -> (0 <= d)%Z -> R < gamma d -> k2 + IZR d <= k1 -> R * V k2 < V k1.
Proof.
  intros k2_positive V_k2_positive whole beyond distant.
  assert (ratio : V k1 / V k2 >= gamma d) by (apply steps_multiply; auto; lra).
  apply (Rmult_lt_reg_r (/ V k2)); [now apply Rinv_0_lt_compat|].
  rewrite Rmult_assoc, Rinv_r by lra. unfold Rdiv in ratio. lra.
Qed.

Lemma gamma_zero : gamma 0 = 1.
Proof.
  unfold gamma, gamma_of. pose proof (binade_positive_Z a).
  rewrite Z.div_0_l, Z.mod_0_l by lia. simpl. field.
Qed.

End Steps.
