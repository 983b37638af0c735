(** Euclidean norms of computed vectors and of their errors. *)
From Coq Require Import Reals Lra Psatz List.
Import ListNotations.

Open Scope R_scope.

Definition sum_of_squares (x : list R) : R := fold_right (fun x rest => x ^ 2 + rest) 0 x.
Definition norm (x : list R) : R := sqrt (sum_of_squares x).

(** A vector as pairs of a computed element x_k' and its error e_k; the real one is x_k' - e_k. *)
Definition vector : Type := list (R * R).
Definition computed (v : vector) : list R := map fst v.
Definition errors (v : vector) : list R := map snd v.
Definition real (v : vector) : list R := map (fun element => fst element - snd element) v.

Lemma sum_of_squares_is_nonnegative x : 0 <= sum_of_squares x.
Proof.
  induction x as [|y others IH]; simpl; [lra|].
  change (y * (y * 1)) with (y ^ 2). pose proof (pow2_ge_0 y). lra.
Qed.

Lemma norm_is_nonnegative x : 0 <= norm x.
Proof. apply sqrt_pos. Qed.

Lemma norm_squared x : norm x ^ 2 = sum_of_squares x.
Proof. unfold norm. simpl. rewrite Rmult_1_r. apply sqrt_sqrt, sum_of_squares_is_nonnegative. Qed.

Definition dot (v : vector) : R := fold_right (fun e rest => fst e * snd e + rest) 0 v.

Lemma square_below_means_below x y : 0 <= y -> x ^ 2 <= y ^ 2 -> x <= y.
Proof. intros. apply Rnot_lt_le. intros above. nra. Qed.

(** Cauchy and Schwarz. *)
Lemma dot_is_at_most_norms v :
  dot v ^ 2 <= sum_of_squares (computed v) * sum_of_squares (errors v).
Proof.
  induction v as [|[x e] others IH]; [simpl; lra|].
  cbn [dot fold_right computed errors map fst snd sum_of_squares].
  fold (dot others) (computed others) (errors others).
  fold (sum_of_squares (computed others)) (sum_of_squares (errors others)).
  pose proof (sum_of_squares_is_nonnegative (computed others)) as p_positive.
  pose proof (sum_of_squares_is_nonnegative (errors others)) as q_positive.
  set (p := sum_of_squares (computed others)) in *.
  set (q := sum_of_squares (errors others)) in *. set (d := dot others) in *.
  assert (mixed : 2 * (x * e) * d <= x ^ 2 * q + p * e ^ 2).
  { apply square_below_means_below.
    - pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 e).
      apply Rplus_le_le_0_compat; now apply Rmult_le_pos.
    - (* 4 x^2 e^2 d^2 <= 4 x^2 e^2 p q <= (x^2 q + p e^2)^2 *)
      assert (4 * (x ^ 2 * e ^ 2) * d ^ 2 <= 4 * (x ^ 2 * e ^ 2) * (p * q)).
      { apply Rmult_le_compat_l; auto. pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 e). nra. }
      pose proof (pow2_ge_0 (x ^ 2 * q - p * e ^ 2)). nra. }
  nra.
Qed.

Lemma real_squares v :
  sum_of_squares (real v) = sum_of_squares (computed v) - 2 * dot v + sum_of_squares (errors v).
Proof.
  induction v as [|[x e] others IH]; [simpl; ring|].
  cbn [real computed errors map fst snd sum_of_squares dot fold_right].
  fold (real others) (computed others) (errors others) (dot others).
  fold (sum_of_squares (real others)) (sum_of_squares (computed others)).
  fold (sum_of_squares (errors others)). rewrite IH. ring.
Qed.

Lemma real_norm_is_at_most v : norm (real v) <= norm (computed v) + norm (errors v).
Proof.
  apply square_below_means_below.
  - pose proof (norm_is_nonnegative (computed v)). pose proof (norm_is_nonnegative (errors v)). lra.
  - rewrite norm_squared, real_squares.
    pose proof (norm_squared (computed v)) as p. pose proof (norm_squared (errors v)) as q.
    pose proof (dot_is_at_most_norms v) as small. rewrite <- p, <- q in small |- *.
    assert (- dot v <= norm (computed v) * norm (errors v)); [|nra].
    apply square_below_means_below.
    + apply Rmult_le_pos; apply norm_is_nonnegative.
    + nra.
Qed.

Lemma squares_of_opposites (v : vector) :
  sum_of_squares (map (fun e => snd (fst e - snd e, - snd e)) v) = sum_of_squares (map snd v).
Proof.
  induction v as [|[x e] others IH]; [reflexivity|]. cbn [map sum_of_squares fold_right fst snd].
  fold (sum_of_squares (map (fun e => - snd e) others)) (sum_of_squares (map snd others)).
  cbn [snd] in IH. rewrite IH. ring.
Qed.

(** The triangle inequality: abs(|x| - |x'|) is at most the norm of the errors. *)
Theorem norms_are_near v : Rabs (norm (real v) - norm (computed v)) <= norm (errors v).
Proof.
  pose proof (real_norm_is_at_most v) as above.
  assert (below : norm (computed v) <= norm (real v) + norm (errors v)).
  { set (back := map (fun element => (fst element - snd element, - snd element)) v).
    pose proof (real_norm_is_at_most back) as other.
    replace (real back) with (computed v) in other.
    - replace (computed back) with (real v) in other.
      + replace (norm (errors back)) with (norm (errors v)) in other; auto.
        unfold norm. f_equal. unfold back, errors. rewrite map_map.
        symmetry. apply squares_of_opposites.
      + unfold back, computed, real. now rewrite map_map.
    - unfold back, computed, real. rewrite map_map. apply map_ext. intros [x e]. simpl. ring. }
  apply Rabs_le. lra.
Qed.
