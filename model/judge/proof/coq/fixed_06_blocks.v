(** docs/fixed_point.md, theorem 6: block floating point. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core.

Open Scope R_scope.

(** The operands of a comparison; t x is each of them times t. *)
Definition operands : Type := list R.
Definition scaled (t : R) (x : operands) : operands := map (fun operand => t * operand) x.

(** f is homogeneous of degree d: a root has half of its radicand's, so d is a real number. *)
Definition homogeneous (d : R) (f : operands -> R) : Prop :=
  forall t x, 0 < t -> f (scaled t x) = Rpower t d * f x.

(** The answer of a lane; none where it does not decide. *)
Definition lane : Type := operands -> option comparison.

(** The decision on these operands is right. *)
Definition right_for (f g : operands -> R) (decide : lane) (x : operands) : Prop :=
  forall answer, decide x = Some answer -> Rcompare (f x) (g x) = answer.

Lemma scaled_difference_keeps_order s p q : 0 < s -> Rcompare (s * p) (s * q) = Rcompare p q.
Proof. intros. apply Rcompare_mult_l. auto. Qed.

(** "f(t x) - g(t x) = t^d (f(x) - g(x)) has the sign of f(x) - g(x), as t^d > 0." *)
Theorem scaled_operands_have_the_order d f g t x :
  homogeneous d f -> homogeneous d g -> 0 < t ->
  Rcompare (f (scaled t x)) (g (scaled t x)) = Rcompare (f x) (g x).
Proof.
  intros f_degree g_degree positive. rewrite f_degree, g_degree by auto.
  apply scaled_difference_keeps_order. apply exp_pos.
Qed.

(** "Let 2^e be the least power of two above the magnitudes of all operands, but at least twice the
    least normal number": then all operands 2^-e x are below 1. *)
Theorem block_operands_are_below_one e x :
  Forall (fun operand => Rabs operand < bpow radix2 e) x ->
  Forall (fun operand => Rabs operand < 1) (scaled (bpow radix2 (- e)) x).
Proof.
  intros below. unfold scaled. apply Forall_map. apply Forall_impl with (2 := below).
  intros operand small. rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 (- e))) by apply bpow_ge_0.
  apply Rlt_le_trans with (bpow radix2 (- e) * bpow radix2 e).
  - apply Rmult_lt_compat_l; [apply bpow_gt_0|auto].
  - rewrite <- bpow_plus, Z.add_opp_diag_l. apply Rle_refl.
Qed.

(** Theorem 6. *)
Theorem decision_on_block_is_right d f g (decide : lane) e x answer :
  homogeneous d f -> homogeneous d g ->
  (forall z, Forall (fun operand => Rabs operand < 1) z -> right_for f g decide z) ->
  Forall (fun operand => Rabs operand < bpow radix2 e) x ->
  decide (scaled (bpow radix2 (- e)) x) = Some answer ->
  Rcompare (f x) (g x) = answer.
Proof.
  intros f_degree g_degree lane_is_right below decided.
  rewrite <- (scaled_operands_have_the_order d f g (bpow radix2 (- e)) x)
    by (auto; apply bpow_gt_0).
  apply (lane_is_right _ (block_operands_are_below_one e x below)). exact decided.
Qed.

(** "To truncate t x to 2^-W is to truncate x to 2^(e - W)." *)
Theorem truncation_scales W e x :
  Zfloor (bpow radix2 (- e) * x / bpow radix2 (- W)) = Zfloor (x / bpow radix2 (e - W)).
Proof.
  f_equal. unfold Rdiv. rewrite <- !bpow_opp.
  replace (bpow radix2 (- e) * x * bpow radix2 (- - W))
    with (x * (bpow radix2 (- e) * bpow radix2 (- - W))) by ring.
  rewrite <- bpow_plus. do 2 f_equal. ring.
Qed.

(** "Degrees follow from the expressions." *)
Section Degrees.

Variables (d d' : R) (f g : operands -> R).
Hypothesis f_degree : homogeneous d f.

Theorem input_has_degree_one k : homogeneous 1 (fun x => nth k x 0).
Proof.
  intros t x positive. rewrite Rpower_1 by auto. unfold scaled.
  rewrite <- (Rmult_0_r t) at 1. apply (map_nth (fun operand => t * operand)).
Qed.

Theorem constant_has_degree_zero c : homogeneous 0 (fun _ => c).
Proof. intros t x positive. rewrite Rpower_O by auto. ring. Qed.

Theorem zero_has_every_degree : homogeneous d (fun _ => 0).
Proof. intros t x positive. ring. Qed.

Theorem product_adds_degrees : homogeneous d' g -> homogeneous (d + d') (fun x => f x * g x).
Proof. intros g_degree t x positive. rewrite f_degree, g_degree, Rpower_plus by auto. ring. Qed.

Theorem root_halves_degree :
  (forall x, 0 <= f x) -> homogeneous (d / 2) (fun x => sqrt (f x)).
Proof.
  intros sign t x positive. rewrite f_degree by auto.
  rewrite sqrt_mult; [|apply Rlt_le, exp_pos|apply sign]. f_equal.
  replace d with (d / 2 + d / 2) at 1 by field.
  rewrite Rpower_plus. apply sqrt_square. apply Rlt_le, exp_pos.
Qed.

Theorem sum_keeps_degree : homogeneous d g -> homogeneous d (fun x => f x + g x).
Proof. intros g_degree t x positive. rewrite f_degree, g_degree by auto. ring. Qed.

Theorem difference_keeps_degree : homogeneous d g -> homogeneous d (fun x => f x - g x).
Proof. intros g_degree t x positive. rewrite f_degree, g_degree by auto. ring. Qed.

Theorem minimum_keeps_degree : homogeneous d g -> homogeneous d (fun x => Rmin (f x) (g x)).
Proof.
  intros g_degree t x positive. rewrite f_degree, g_degree by auto.
  assert (0 < Rpower t d) by apply exp_pos. unfold Rmin. repeat destruct Rle_dec; auto; nra.
Qed.

Theorem maximum_keeps_degree : homogeneous d g -> homogeneous d (fun x => Rmax (f x) (g x)).
Proof.
  intros g_degree t x positive. rewrite f_degree, g_degree by auto.
  assert (0 < Rpower t d) by apply exp_pos. unfold Rmax. repeat destruct Rle_dec; auto; nra.
Qed.

Theorem absolute_keeps_degree : homogeneous d (fun x => Rabs (f x)).
Proof.
  intros t x positive. rewrite f_degree, Rabs_mult by auto.
  rewrite (Rabs_pos_eq (Rpower t d)); auto. apply Rlt_le, exp_pos.
Qed.

End Degrees.
