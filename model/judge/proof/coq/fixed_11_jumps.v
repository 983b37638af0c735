(** docs/fixed_point.md, theorem 11: jumps. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.

Open Scope R_scope.

(** sign(x) is -1 where x < 0 and 1 elsewhere. *)
Definition sign (x : R) : R := if Rlt_dec x 0 then -1 else 1.

(** "If X u - x is 0 or less and above -u, then X < 0 if and only if x < 0." *)
Theorem sign_is_exact X u x : 0 < u -> - u < IZR X * u - x <= 0 -> (X < 0)%Z <-> x < 0.
Proof.
  intros positive error. split; intros negative.
  - assert (IZR X <= -1) by (apply IZR_le; lia). nra.
  - apply lt_IZR. apply (Rmult_lt_reg_r u); auto. lra.
Qed.

Theorem sign_of_lane X u x :
  0 < u -> - u < IZR X * u - x <= 0 -> (if Z_lt_dec X 0 then -1 else 1) = sign x.
Proof.
  intros positive error. pose proof (sign_is_exact X u x positive error) as same.
  unfold sign. destruct (Z_lt_dec X 0), (Rlt_dec x 0); tauto || reflexivity.
Qed.

(** mod(x, y) is x - y floor(x / y), for a constant y > 0. *)
Definition modulo (x y : R) : R := x - y * IZR (Zfloor (x / y)).

Section Modulo.

(** The lane computes X u - k M, where M is y rounded. *)
Variables computed x y M : R.
Variable k : Z.
Hypothesis divisor : 0 < y.

Lemma floor_is x' : 0 <= x' - IZR k * y < y -> Zfloor (x' / y) = k.
Proof.
  intros inside. apply Zfloor_imp. rewrite plus_IZR.
  split; [apply (Rmult_le_reg_r y)|apply (Rmult_lt_reg_r y)]; auto;
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(** "Its error is that of X u, less k (M - y), if x / y has the same floor." *)
Theorem modulo_error :
  Zfloor (x / y) = k ->
  computed - IZR k * M - modulo x y = (computed - x) - IZR k * (M - y).
Proof. intros same. unfold modulo. rewrite same. ring. Qed.

(** "If X u is off by e0 it has." *)
Theorem known_error_keeps_floor e0 :
  k = Zfloor ((computed - e0) / y) -> x = computed - e0 -> Zfloor (x / y) = k.
Proof. now intros -> ->. Qed.

(** "If x = X u - e for an error e in [l, h], it has if h <= X u - k y < y + l." *)
Theorem limit_keeps_floor l h :
  l <= computed - x <= h -> h <= computed - IZR k * y < y + l -> Zfloor (x / y) = k.
Proof. intros error limit. apply floor_is. lra. Qed.

End Modulo.

(** "Both floors grow with X. They agree everywhere if they agree at both ends, and at both sides of
    every X at which the right one steps." *)
Theorem floors_agree_everywhere (taken right : Z -> Z) first last :
  (forall X, first <= X < last -> taken X <= taken (X + 1))%Z ->
  taken first = right first -> taken last = right last ->
  (forall X, (first <= X < last)%Z -> right X <> right (X + 1)%Z ->
     taken X = right X /\ taken (X + 1)%Z = right (X + 1)%Z) ->
  forall X, (first <= X <= last)%Z -> taken X = right X.
Proof.
  intros grows at_first at_last at_steps X inside.
  assert (at_least : forall n, (0 <= n)%Z -> (first + n <= last)%Z ->
            (right (first + n) <= taken (first + n))%Z).
  { refine (natlike_ind _ _ _).
    - rewrite Z.add_0_r. lia.
    - intros n whole IH below. unfold Z.succ in *. rewrite Z.add_assoc in *.
      specialize (IH ltac:(lia)). specialize (grows (first + n)%Z ltac:(lia)).
      destruct (Z.eq_dec (right (first + n)%Z) (right (first + n + 1)%Z)) as [same | step]; [lia|].
      destruct (at_steps (first + n)%Z ltac:(lia) step). lia. }
  assert (at_most : forall n, (0 <= n)%Z -> (first <= last - n)%Z ->
            (taken (last - n) <= right (last - n))%Z).
  { refine (natlike_ind _ _ _).
    - rewrite Z.sub_0_r. lia.
    - intros n whole IH above. unfold Z.succ in *. specialize (IH ltac:(lia)).
      specialize (grows (last - (n + 1))%Z ltac:(lia)).
      replace (last - (n + 1) + 1)%Z with (last - n)%Z in grows by ring.
      destruct (Z.eq_dec (right (last - (n + 1))%Z) (right (last - n)%Z)) as [same | step]; [lia|].
      destruct (at_steps (last - (n + 1))%Z ltac:(lia)) as [left _]; [|lia].
      now replace (last - (n + 1) + 1)%Z with (last - n)%Z by ring. }
  specialize (at_least (X - first)%Z). specialize (at_most (last - X)%Z).
  replace (first + (X - first))%Z with X in at_least by ring.
  replace (last - (last - X))%Z with X in at_most by ring. lia.
Qed.
