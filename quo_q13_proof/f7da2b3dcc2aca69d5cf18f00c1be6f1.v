Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x10 : R.
Variable _x11 : R.
Notation _c := ((_x10 - _x11)%R).
Variable _e10 : R.
Notation r6 := ((_x10 - _e10)%R).
Variable _e11 : R.
Notation r8 := ((_x11 - _e11)%R).
Notation _t := ((r6 - r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r10 := ((_e10 - _e11)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (-8413737) (-22).
Definition f2 := Float2 (4205843) (-21).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x10 i1). (* BND(x10, [-2.00599, 2.0055]) *)
Definition f3 := Float2 (-78867714917361852228453974496880344767841859877668262763156161) (-213).
Definition f4 := Float2 (17683367464164469304418471470572639064505291349639682166197) (-201).
Definition i2 := makepairF f3 f4.
Notation p2 := (BND _e10 i2). (* BND(e10, [-0.00599115, 0.00550219]) *)
Definition s4 := (p1 /\ p2).
Definition f5 := Float2 (-1) (2).
Definition f6 := Float2 (8191) (-11).
Definition i3 := makepairF f5 f6.
Notation p3 := (BND _x11 i3). (* BND(x11, [-4, 3.99951]) *)
Definition s3 := (s4 /\ p3).
Definition f7 := Float2 (-1) (-11).
Definition f8 := Float2 (0) (0).
Definition i4 := makepairF f7 f8.
Notation p4 := (BND _e11 i4). (* BND(e11, [-0.000488281, 0]) *)
Definition s2 := (s3 /\ p4).
Definition f9 := Float2 (-25188905) (-22).
Definition f10 := Float2 (12594451) (-21).
Definition i5 := makepairF f9 f10.
Notation p5 := (BND _c i5). (* BND(c, [-6.0055, 6.0055]) *)
Definition s6 := (not p5).
Definition f11 := Float2 (19252642898011139495377418826374555668530880210755690794421) (-201).
Definition i6 := makepairF f3 f11.
Notation p6 := (BND r1 i6). (* BND(c - t, [-0.00599115, 0.00599047]) *)
Definition s7 := (not p6).
Definition s5 := (s6 \/ s7).
Definition s1 := (s2 /\ s5).
Lemma l3 : s1 -> s5.
Proof.
 intros h0.
 assert (h1 := h0).
 exact (proj2 h1).
Qed.
Lemma l8 : s1 -> s2.
Proof.
 intros h0.
 assert (h1 := h0).
 exact (proj1 h1).
Qed.
Lemma l7 : s1 -> s3.
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj1 h1).
Qed.
Lemma l6 : s1 -> s4.
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj1 h1).
Qed.
Lemma l5 : s1 -> p1 (* BND(x10, [-2.00599, 2.0055]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x11, [-4, 3.99951]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (sub _x10 _x11 i1 i3 i5 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [-6.0055, 6.0055]) *).
Proof.
 intros h0.
 assert (h1 := l5 h0).
 assert (h2 := l9 h0).
 apply t1. exact h1. exact h2.
Qed.
Lemma l2 : s1 -> s7.
Proof.
 intros h0.
 assert (h1 := l3 h0).
 assert (h2 := l4 h0).
 refine (simplify (Ttree false (Tatom false (Abnd 0%nat i5)) (Tatom false (Abnd 1%nat i6))) (Tatom false (Abnd 1%nat i6)) (Abnd 0%nat i5) (List.cons _c (List.cons r1 List.nil)) h2 h1 _) ; finalize.
Qed.
Notation p7 := (r1 = r10). (* EQL(c - t, e10 - e11) *)
Lemma t2 : p7.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* EQL(c - t, e10 - e11) *).
Proof.
 intros h0.
 apply t2.
Qed.
Notation p8 := (BND r10 i6). (* BND(e10 - e11, [-0.00599115, 0.00599047]) *)
Lemma l13 : s1 -> p2 (* BND(e10, [-0.00599115, 0.00550219]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma l14 : s1 -> p4 (* BND(e11, [-0.000488281, 0]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p2 -> p4 -> p8.
Proof.
 intros h0 h1.
 refine (sub _e10 _e11 i2 i4 i6 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(e10 - e11, [-0.00599115, 0.00599047]) *).
Proof.
 intros h0.
 assert (h1 := l13 h0).
 assert (h2 := l14 h0).
 apply t3. exact h1. exact h2.
Qed.
Lemma t4 : p7 -> p8 -> p6.
Proof.
 intros h0 h1.
 refine (bnd_rewrite r1 r10 i6 h0 h1) ; finalize.
Qed.
Lemma l10 : s1 -> p6 (* BND(c - t, [-0.00599115, 0.00599047]) *).
Proof.
 intros h0.
 assert (h1 := l11 h0).
 assert (h2 := l12 h0).
 apply t4. exact h1. exact h2.
Qed.
Lemma l1 : s1 -> False.
Proof.
 intros h0.
 assert (h1 := l2 h0).
 assert (h2 := l10 h0).
 refine (simplify (Tatom false (Abnd 0%nat i6)) Tfalse (Abnd 0%nat i6) (List.cons r1 List.nil) h2 h1 _) ; finalize.
Qed.
End Generated_by_Gappa.
