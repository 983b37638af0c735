(** docs/fixed_point.md, theorem 9: a threshold for each step of magnitudes. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core.
From mixcmp Require Import fixed_03_constants.

Open Scope R_scope.

(** A watched number: its integer w_k, of m_k magnitude bits. *)
Record watched := { w : Z; m : Z }.

Definition has_its_bits (number : watched) : Prop := (- 2 ^ m number <= w number < 2 ^ m number)%Z.

(** With S + 1 steps: -2^(m_k - S + j) <= w_k < 2^(m_k - S + j). *)
Definition within_step (S j : Z) (number : watched) : Prop :=
  (- 2 ^ (m number - S + j) <= w number < 2 ^ (m number - S + j))%Z.

(** "A comparison is in step j, the least from 0 on with" all of them within. *)
Definition in_step (S j : Z) (numbers : list watched) : Prop :=
  (0 <= j)%Z /\ Forall (within_step S j) numbers /\
  forall j', (0 <= j' < j)%Z -> ~ Forall (within_step S j') numbers.

(** Every comparison is in a step. *)
Theorem some_step_holds S numbers :
  (0 <= S)%Z -> Forall has_its_bits numbers ->
  exists j, (0 <= j <= S)%Z /\ in_step S j numbers.
Proof.
  intros whole bits.
  assert (last : Forall (within_step S S) numbers).
  { apply Forall_impl with (2 := bits). intros number size. unfold within_step.
    now replace (m number - S + S)%Z with (m number) by ring. }
  assert (decided : forall j, {Forall (within_step S j) numbers} +
                              {~ Forall (within_step S j) numbers}).
  { intros j. apply Forall_dec. intros number. unfold within_step.
    destruct (Z_le_dec (- 2 ^ (m number - S + j)) (w number)) as [above|]; [|right; lia].
    destruct (Z_lt_dec (w number) (2 ^ (m number - S + j))); [left; lia|right; lia]. }
  assert (search : forall k, (0 <= k)%Z ->
            (exists j, (0 <= j < k)%Z /\ in_step S j numbers) \/
            forall j', (0 <= j' < k)%Z -> ~ Forall (within_step S j') numbers).
  { apply natlike_ind; [right; intros; lia|].
    intros i i_whole [(j & size & found) | none]; [left; exists j; split; auto; lia|].
    destruct (decided i) as [here | not_here].
    - left. exists i. split; [lia|]. now repeat split.
    - right. intros j' size. destruct (Z.eq_dec j' i) as [-> | other]; auto. apply none. lia. }
  destruct (search (S + 1)%Z ltac:(lia)) as [(j & size & found) | none].
  - exists j. split; auto. lia.
  - exfalso. apply (none S); auto. lia.
Qed.

(** t = max(floor(h / u) + 1, floor(-l / u)). *)
Definition step_threshold (u l h : R) : Z := Z.max (Zfloor (h / u) + 1) (Zfloor (- l / u)).

(** Theorem 9. The error is enclosed wherever the watched numbers are in the bounds of step j. *)
Theorem step_decides S j numbers f g u l h n :
  0 < u ->
  (Forall (within_step S j) numbers -> l <= IZR n * u - (f - g) <= h) ->
  in_step S j numbers ->
  ((n >= step_threshold u l h)%Z -> f > g) /\ ((n < - step_threshold u l h)%Z -> f < g).
Proof.
  intros positive enclosure (_ & inside & _). specialize (enclosure inside).
  unfold step_threshold. split; intros reached.
  - apply (constant_decides_greater f g u l h n); auto. lia.
  - pose proof (Zfloor_ub (- l / u)) as upper.
    assert (beyond : IZR n + 1 <= - IZR (Zfloor (- l / u)))
      by (rewrite <- opp_IZR, <- plus_IZR; apply IZR_le; lia).
    assert (below : IZR n < l / u) by (unfold Rdiv in *; lra).
    apply (Rmult_lt_compat_r u) in below; auto.
    unfold Rdiv in below. rewrite Rmult_assoc, Rinv_l in below by lra. lra.
Qed.
