(** docs/fixed_point.md, theorem 10: a function from a table of polynomials. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List Ranalysis.
From Flocq Require Import Core.
Import ListNotations.

Open Scope R_scope.

(** A number cut to a unit, as dropping bits in two's complement does. *)
Definition cut (unit x : R) : R := IZR (Zfloor (x / unit)) * unit.

Lemma cut_takes_less_than_unit unit x : 0 < unit -> 0 <= x - cut unit x < unit.
Proof.
  intros positive. unfold cut.
  pose proof (Zfloor_lb (x / unit)) as lower. pose proof (Zfloor_ub (x / unit)) as upper.
  apply (Rmult_le_compat_r unit) in lower; [|lra]. apply (Rmult_lt_compat_r unit) in upper; auto.
  replace (x / unit * unit) with x in lower, upper by (field; lra). lra.
Qed.

(** A multiple of a finer unit loses no more than the difference of the units. *)
Lemma cut_of_multiple unit ratio n :
  0 < unit -> (1 <= ratio)%Z ->
  let coarse := IZR ratio * unit in
  0 <= IZR n * unit - cut coarse (IZR n * unit) <= coarse - unit.
Proof.
  intros positive whole coarse. unfold cut, coarse. apply (IZR_le 1) in whole as real_ratio.
  replace (IZR n * unit / (IZR ratio * unit)) with (IZR n / IZR ratio) by (field; lra).
  rewrite Zfloor_div by lia.
  pose proof (Z.div_mod n ratio) as parts. pose proof (Z.mod_pos_bound n ratio) as rest.
  replace (IZR n) with (IZR (n / ratio) * IZR ratio + IZR (n mod ratio))
    by (rewrite <- mult_IZR, <- plus_IZR; f_equal; lia).
  assert (0 <= IZR (n mod ratio)) by (apply (IZR_le 0); lia).
  assert (IZR (n mod ratio) <= IZR ratio - 1) by (rewrite <- minus_IZR; apply IZR_le; lia).
  split; nra.
Qed.

(** The words c_k of a piece, each with its unit w_k, from c_0 on; there is a last one, c_d. *)
Record word := { c : R; w : R }.

(** p(t), and s_0 as the lane computes it. *)
Fixpoint polynomial (t : R) (first : word) (rest : list word) : R :=
  match rest with
  | nil => c first
  | next :: others => c first + polynomial t next others * t
  end.

Fixpoint computed (t : R) (first : word) (rest : list word) : R :=
  match rest with
  | nil => c first
  | next :: others => c first + cut (w first) (computed t next others * t)
  end.

(** w_0 + w_1 T + ... + w_(d-1) T^(d-1). *)
Fixpoint cuts (T : R) (first : word) (rest : list word) : R :=
  match rest with
  | nil => 0
  | next :: others => w first + T * cuts T next others
  end.

(** "Each cut of a product lowers s_k by less than w_k, and s_0 by less than that times t^k." *)
Lemma cuts_lower_at_most t T first rest :
  0 <= t <= T -> Forall (fun word => 0 < w word) (first :: rest) ->
  0 <= polynomial t first rest - computed t first rest <= cuts T first rest.
Proof.
  intros [t_sign t_most]. revert first.
  induction rest as [|next others IH]; intros first units; simpl; [lra|].
  inversion units as [|? ? positive rest_positive]; subst.
  specialize (IH next rest_positive).
  pose proof (cut_takes_less_than_unit (w first) (computed t next others * t) positive).
  assert (0 <= (polynomial t next others - computed t next others) * t <=
          T * cuts T next others) by (split; nra).
  lra.
Qed.

(** s_0 is a multiple of w_0, as c_0 is. *)
Lemma computed_is_multiple t first rest n :
  c first = IZR n * w first -> exists n', computed t first rest = IZR n' * w first.
Proof.
  intros multiple. destruct rest as [|next others]; [now exists n|].
  exists (n + Zfloor (computed t next others * t / w first))%Z.
  simpl. unfold cut. rewrite plus_IZR, multiple. ring.
Qed.

(** Theorem 10, for the computed argument: p(t) - f(X u) lies in [a, b]. *)
Theorem function_error t T first rest n ratio value a b :
  0 <= t <= T -> Forall (fun word => 0 < w word) (first :: rest) ->
  c first = IZR n * w first -> (1 <= ratio)%Z ->
  a <= polynomial t first rest - value <= b ->
  let v := IZR ratio * w first in
  a - cuts T first rest - (v - w first) <= cut v (computed t first rest) - value <= b.
Proof.
  intros t_size units multiple whole near v.
  pose proof (cuts_lower_at_most t T first rest t_size units) as lowered.
  destruct (computed_is_multiple t first rest n multiple) as [n' is_multiple].
  inversion units as [|? ? positive _]; subst.
  pose proof (cut_of_multiple (w first) ratio n' positive whole) as last.
  rewrite <- is_multiple in last. fold v in last. lra.
Qed.

(** "The hardware adds the whole product to c_k and cuts the sum. The result is the same, since c_k
    is a multiple of the unit to which the product would be cut." *)
Theorem cut_of_sum unit n x :
  0 < unit -> cut unit (IZR n * unit + x) = IZR n * unit + cut unit x.
Proof.
  intros positive. unfold cut.
  replace ((IZR n * unit + x) / unit) with (x / unit + IZR n) by (field; lra).
  replace (Zfloor (x / unit + IZR n)) with (Zfloor (x / unit) + n)%Z.
  - rewrite plus_IZR. ring.
  - symmetry. apply Zfloor_imp. rewrite !plus_IZR.
    pose proof (Zfloor_lb (x / unit)). pose proof (Zfloor_ub (x / unit)). lra.
Qed.

(** "If x = X u - e ... f(X u) - f(x) = f'(z) e for a z between X u and x." *)
Theorem argument_error f f' argument e :
  (forall z, Rmin (argument - e) argument <= z <= Rmax (argument - e) argument ->
     derivable_pt_lim f z (f' z)) ->
  exists z, Rmin (argument - e) argument <= z <= Rmax (argument - e) argument /\
    f argument - f (argument - e) = f' z * e.
Proof.
  intros slope. destruct (Rtotal_order e 0) as [negative | [-> | positive]].
  - rewrite Rmin_right, Rmax_left in * by lra.
    destruct (MVT_cor2 f f' argument (argument - e)) as (z & difference & inside); [lra|auto|].
    exists z. split; lra.
  - exists argument. rewrite Rminus_0_r. pose proof (Rmin_r argument argument).
    pose proof (Rmax_r argument argument). split; [lra|ring].
  - rewrite Rmin_left, Rmax_right in * by lra.
    destruct (MVT_cor2 f f' (argument - e) argument) as (z & difference & inside); [lra|auto|].
    exists z. split; lra.
Qed.

(** "And f' = c F'" for f(x) = F(c x + d). *)
Theorem slope_of_scaled_argument F F' factor d x :
  derivable_pt_lim F (factor * x + d) (F' (factor * x + d)) ->
  derivable_pt_lim (fun x => F (factor * x + d)) x (factor * F' (factor * x + d)).
Proof.
  intros slope. rewrite Rmult_comm.
  apply (derivable_pt_lim_comp (fun x => factor * x + d) F); auto.
  intros eps eps_positive. exists (mkposreal 1 Rlt_0_1). intros step nonzero _.
  replace ((factor * (x + step) + d - (factor * x + d)) / step - factor) with 0 by (field; auto).
  now rewrite Rabs_R0.
Qed.

(** "If F has values only above an end z, the numbers that X u - e may stand for must lie above
    (z - d) / c for c > 0, and below it for c < 0." *)
Theorem arguments_above_end factor d x z :
  (0 < factor -> factor * x + d > z <-> x > (z - d) / factor) /\
  (factor < 0 -> factor * x + d > z <-> x < (z - d) / factor).
Proof.
  split; intros sign.
  - assert (is_end : factor * ((z - d) / factor) = z - d) by (field; lra). split; intros; nra.
  - assert (is_end : factor * ((z - d) / factor) = z - d) by (field; lra). split; intros; nra.
Qed.

(** "x^p with 0 < p < 1 ... is concave and 0 at 0, so |f(X u) - f(x)| <= |e|^p as well." *)
Definition power (p x : R) : R := if Rlt_dec 0 x then Rpower x p else 0.

Lemma power_of_share_is_larger p r : 0 < p < 1 -> 0 < r <= 1 -> r <= Rpower r p.
Proof.
  intros p_inside r_inside. unfold Rpower.
  assert (logarithm : ln r <= 0).
  { destruct (proj2 r_inside) as [less | equal].
    - rewrite <- ln_1. apply Rlt_le, ln_increasing; lra.
    - rewrite equal, ln_1. lra. }
  rewrite <- (exp_ln r) at 1 by lra.
  assert (order : ln r <= p * ln r) by nra. destruct order as [less | equal].
  - now apply Rlt_le, exp_increasing.
  - rewrite <- equal. apply Rle_refl.
Qed.

Lemma powers_of_parts p x y :
  0 < p < 1 -> 0 < x -> 0 < y -> Rpower (x + y) p <= Rpower x p + Rpower y p.
Proof.
  intros p_inside x_sign y_sign.
  assert (parts : forall part, 0 < part <= x + y ->
            part / (x + y) * Rpower (x + y) p <= Rpower part p).
  { intros part size.
    replace (Rpower part p) with (Rpower (part / (x + y)) p * Rpower (x + y) p).
    - apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|].
      apply power_of_share_is_larger; auto. split; [apply Rdiv_lt_0_compat; lra|].
      apply (Rmult_le_reg_r (x + y)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    - rewrite Rpower_mult_distr; [|apply Rdiv_lt_0_compat; lra|lra]. f_equal. field. lra. }
  pose proof (parts x ltac:(lra)). pose proof (parts y ltac:(lra)).
  replace (Rpower (x + y) p)
    with (x / (x + y) * Rpower (x + y) p + y / (x + y) * Rpower (x + y) p) by (field; lra).
  lra.
Qed.

Lemma power_increases p x y : 0 < p -> x <= y -> power p x <= power p y.
Proof.
  intros p_sign order. unfold power. destruct (Rlt_dec 0 x), (Rlt_dec 0 y); try lra.
  - apply Rle_Rpower_l; lra.
  - apply Rlt_le, exp_pos.
Qed.

(** "Where the computed argument is beyond the end, f stands for its value at the end." *)
Theorem power_error p x y : 0 < p < 1 -> Rabs (power p x - power p y) <= power p (Rabs (x - y)).
Proof.
  intros p_inside.
  assert (ordered : forall s t, s <= t -> power p t - power p s <= power p (t - s)).
  { intros s t [less | ->].
    2: { unfold Rminus. rewrite Rplus_opp_r. unfold power. destruct Rlt_dec; lra. }
    destruct (Rlt_le_dec 0 s) as [positive | not_positive].
    - unfold power. destruct (Rlt_dec 0 t), (Rlt_dec 0 s), (Rlt_dec 0 (t - s)); try lra.
      pose proof (powers_of_parts p s (t - s) p_inside positive ltac:(lra)) as parts.
      replace (s + (t - s)) with t in parts by ring. lra.
    - assert (power p s = 0) as -> by (unfold power; destruct Rlt_dec; lra).
      rewrite Rminus_0_r. apply power_increases; lra. }
  destruct (Rle_lt_dec x y) as [order | order].
  - pose proof (ordered x y order). pose proof (power_increases p x y ltac:(lra) order).
    rewrite (Rabs_left1 (power p x - power p y)), (Rabs_left1 (x - y)) by lra.
    replace (- (x - y)) with (y - x) by ring. lra.
  - pose proof (ordered y x ltac:(lra)). pose proof (power_increases p y x ltac:(lra) ltac:(lra)).
    rewrite !Rabs_pos_eq by lra. lra.
Qed.

(** "The numbers of a binade, 2^e <= x < 2^(e + 1), have errors from -2^(e - m) to 0": m leading
    fraction bits of the encoding stand for x. *)
Theorem encoding_error e m x :
  let leading := cut (bpow radix2 (e - m)) x in - bpow radix2 (e - m) <= leading - x <= 0.
Proof.
  intros leading. pose proof (cut_takes_less_than_unit (bpow radix2 (e - m)) x (bpow_gt_0 _ _)).
  unfold leading. lra.
Qed.
