(** docs/error_bounds.md, theorem 11: the decision of several parts is their true verdict. *)
From Coq Require Import List Lia.
Import ListNotations.

Inductive verdict := less | equal | greater | unordered.

Definition is_verdict (v w : verdict) : {v = w} + {v <> w}.
Proof. decide equality. Defined.

(** How a comparison joins its parts: the last verdict in the order less < equal < unordered <
    greater ([all]), or the first in less < unordered < equal < greater ([any]). *)
Inductive join := all | any.

Definition place (how : join) (v : verdict) : nat :=
  match how, v with
  | _, less => 0
  | all, equal => 1 | all, unordered => 2
  | any, unordered => 1 | any, equal => 2
  | _, greater => 3
  end.

(** The one of two verdicts that wins. *)
Definition winner (how : join) (v w : verdict) : verdict :=
  match how with
  | all => if Nat.leb (place all v) (place all w) then w else v
  | any => if Nat.leb (place any v) (place any w) then v else w
  end.

(** The verdict of parts, of which there is at least one. *)
Fixpoint joined (how : join) (first : verdict) (rest : list verdict) : verdict :=
  match rest with
  | nil => first
  | next :: others => winner how first (joined how next others)
  end.

(** The verdict that decides the comparison whatever the other parts are. *)
Definition decisive (how : join) : verdict := match how with all => greater | any => less end.

(** A part's decision: a verdict, or none. *)
Definition decision : Type := option verdict.

Definition says_decisive (how : join) (d : decision) : bool :=
  match d with Some v => if is_verdict v (decisive how) then true else false | None => false end.

(** The verdicts of decisions, if there is no undecided one. *)
Fixpoint all_decided (decisions : list decision) : option (list verdict) :=
  match decisions with
  | nil => Some nil
  | None :: _ => None
  | Some v :: others =>
      match all_decided others with Some verdicts => Some (v :: verdicts) | None => None end
  end.

(** "A lane decides greater (less for any) if some part's decision is that; else, if all parts are
    decided, the last (first) of their decisions; else nothing." *)
Definition lane_decision (how : join) (first : decision) (rest : list decision) : decision :=
  if existsb (says_decisive how) (first :: rest) then Some (decisive how)
  else match all_decided (first :: rest) with
       | Some (v :: verdicts) => Some (joined how v verdicts)
       | _ => None
       end.

(** "A part that is decided has decided v_k." *)
Definition right (d : decision) (true_verdict : verdict) : Prop :=
  d = None \/ d = Some true_verdict.

Lemma decisive_wins how v : winner how (decisive how) v = decisive how /\
                            winner how v (decisive how) = decisive how.
Proof. destruct how, v; split; reflexivity. Qed.

(** "If v_k is greater for some k then it is the last, since nothing comes after it." *)
Lemma one_decisive_part_decides how first rest :
  In (decisive how) (first :: rest) -> joined how first rest = decisive how.
Proof.
  revert first. induction rest as [|next others IH]; intros first.
  - intros [same | []]. exact same.
  - intros [-> | inside]; simpl; [apply decisive_wins|].
    rewrite (IH next inside). apply decisive_wins.
Qed.

Lemma winner_is_one how v w : winner how v w = v \/ winner how v w = w.
Proof. destruct how, v, w; simpl; auto. Qed.

Lemma winner_is_last v w :
  place all v <= place all (winner all v w) /\ place all w <= place all (winner all v w).
Proof. destruct v, w; simpl; lia. Qed.

Lemma winner_is_first v w :
  place any (winner any v w) <= place any v /\ place any (winner any v w) <= place any w.
Proof. destruct v, w; simpl; lia. Qed.

(** The joined verdict is that of a part; no part comes after it ([all]), or before it ([any]). *)
Theorem joined_is_last_or_first how first rest :
  In (joined how first rest) (first :: rest) /\
  forall v, In v (first :: rest) ->
    match how with
    | all => place all v <= place all (joined all first rest)
    | any => place any (joined any first rest) <= place any v
    end.
Proof.
  revert first. induction rest as [|next others IH]; intros first.
  - split; [now left|]. intros v [-> | []]. destruct how; cbn [joined]; lia.
  - destruct (IH next) as [inside beyond]. cbn [joined]. split.
    + destruct (winner_is_one how first (joined how next others)) as [-> | ->];
        [now left|now right].
    + intros v [<- | later]; [|specialize (beyond v later)]; destruct how.
      * apply winner_is_last.
      * apply winner_is_first.
      * pose proof (winner_is_last first (joined all next others)). lia.
      * pose proof (winner_is_first first (joined any next others)). lia.
Qed.

Lemma all_decided_are_true decisions verdicts truths :
  Forall2 right decisions truths -> all_decided decisions = Some verdicts -> verdicts = truths.
Proof.
  intros rights. revert verdicts.
  induction rights as [|d v ds vs is_right rights IH]; simpl; intros verdicts is_decided.
  - congruence.
  - destruct is_right as [-> | ->]; [discriminate|].
    destruct (all_decided ds) as [others|]; [|discriminate].
    injection is_decided as <-. f_equal. now apply IH.
Qed.

(** Theorem 11: "if it decides, its verdict is the true one". *)
Theorem decided_parts_are_right how first rest first_truth truths verdict :
  Forall2 right (first :: rest) (first_truth :: truths) ->
  lane_decision how first rest = Some verdict ->
  verdict = joined how first_truth truths.
Proof.
  intros rights. unfold lane_decision.
  destruct (existsb (says_decisive how) (first :: rest)) eqn:some_decisive.
  - intros [= <-]. symmetry. apply one_decisive_part_decides.
    apply existsb_exists in some_decisive. destruct some_decisive as (d & inside & says).
    revert inside. clear - rights says. induction rights as [|d' v ds vs is_right rights IH].
    + intros [].
    + intros [-> | later]; [left|right; auto].
      destruct is_right as [-> | ->]; [discriminate|].
      simpl in says. now destruct (is_verdict v (decisive how)).
  - destruct (all_decided (first :: rest)) as [[|v verdicts]|] eqn:is_decided; try discriminate.
    intros [= <-]. apply (all_decided_are_true _ _ _ rights) in is_decided.
    now injection is_decided as -> ->.
Qed.
