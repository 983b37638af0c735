Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x0 : R.
Variable _x1 : R.
Notation _c := ((_x0 * _x1)%R).
Variable _e0 : R.
Notation r6 := ((_x0 - _e0)%R).
Variable _e1 : R.
Notation r8 := ((_x1 - _e1)%R).
Notation _t := ((r6 * r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r12 := ((_x0 * _e1)%R).
Notation r13 := ((_x1 * _e0)%R).
Notation r11 := ((r12 + r13)%R).
Notation r14 := ((_e0 * _e1)%R).
Notation r10 := ((r11 - r14)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (3217) (-12).
Definition i1 := makepairF f1 f1.
Notation p1 := (BND _x0 i1). (* BND(x0, [0.7854, 0.7854]) *)
Definition f2 := Float2 (13980533929816739769045285477420835621039767125767051) (-192).
Definition f3 := Float2 (3495133482454184942261321369355208905259941781441763) (-190).
Definition i2 := makepairF f2 f3.
Notation p2 := (BND _e0 i2). (* BND(e0, [2.22723e-06, 2.22723e-06]) *)
Definition s4 := (p1 /\ p2).
Definition f4 := Float2 (1) (1).
Definition i3 := makepairF f4 f4.
Notation p3 := (BND _x1 i3). (* BND(x1, [2, 2]) *)
Definition s3 := (s4 /\ p3).
Definition f5 := Float2 (0) (0).
Definition i4 := makepairF f5 f5.
Notation p4 := (BND _e1 i4). (* BND(e1, [0, 0]) *)
Definition s2 := (s3 /\ p4).
Definition f6 := Float2 (3217) (-11).
Definition i5 := makepairF f6 f6.
Notation p5 := (BND _c i5). (* BND(c, [1.5708, 1.5708]) *)
Definition s6 := (not p5).
Definition f7 := Float2 (13980533929816739769045285477420835621039767125767051) (-191).
Definition f8 := Float2 (3495133482454184942261321369355208905259941781441763) (-189).
Definition i6 := makepairF f7 f8.
Notation p6 := (BND r1 i6). (* BND(c - t, [4.45446e-06, 4.45446e-06]) *)
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
Lemma l5 : s1 -> p1 (* BND(x0, [0.7854, 0.7854]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x1, [2, 2]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (mul_pp _x0 _x1 i1 i3 i5 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [1.5708, 1.5708]) *).
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
Definition f9 := Float2 (1232506043607908660149758335264266805716465679074380608285) (-189).
Definition f10 := Float2 (4930024174431634640599033341057067222865862716297522433141) (-191).
Definition i7 := makepairF f9 f10.
Notation p7 := (BND _t i7). (* BND(t, [1.5708, 1.5708]) *)
Definition f11 := Float2 (1232506043607908660149758335264266805716465679074380608285) (-190).
Definition f12 := Float2 (4930024174431634640599033341057067222865862716297522433141) (-192).
Definition i8 := makepairF f11 f12.
Notation p8 := (BND r6 i8). (* BND(x0 - e0, [0.785398, 0.785398]) *)
Lemma l13 : s1 -> p2 (* BND(e0, [2.22723e-06, 2.22723e-06]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma t2 : p1 -> p2 -> p8.
Proof.
 intros h0 h1.
 refine (sub _x0 _e0 i1 i2 i8 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(x0 - e0, [0.785398, 0.785398]) *).
Proof.
 intros h0.
 assert (h1 := l5 h0).
 assert (h2 := l13 h0).
 apply t2. exact h1. exact h2.
Qed.
Notation p9 := (BND r8 i3). (* BND(x1 - e1, [2, 2]) *)
Lemma l15 : s1 -> p4 (* BND(e1, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p3 -> p4 -> p9.
Proof.
 intros h0 h1.
 refine (sub _x1 _e1 i3 i4 i3 h0 h1 _) ; finalize.
Qed.
Lemma l14 : s1 -> p9 (* BND(x1 - e1, [2, 2]) *).
Proof.
 intros h0.
 assert (h1 := l9 h0).
 assert (h2 := l15 h0).
 apply t3. exact h1. exact h2.
Qed.
Lemma t4 : p8 -> p9 -> p7.
Proof.
 intros h0 h1.
 refine (mul_pp r6 r8 i8 i3 i7 h0 h1 _) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* BND(t, [1.5708, 1.5708]) *).
Proof.
 intros h0.
 assert (h1 := l12 h0).
 assert (h2 := l14 h0).
 apply t4. exact h1. exact h2.
Qed.
Lemma t5 : p5 -> p7 -> p6.
Proof.
 intros h0 h1.
 refine (sub _c _t i5 i7 i6 h0 h1 _) ; finalize.
Qed.
Lemma l10 : s1 -> p6 (* BND(c - t, [4.45446e-06, 4.45446e-06]) *).
Proof.
 intros h0.
 assert (h1 := l4 h0).
 assert (h2 := l11 h0).
 apply t5. exact h1. exact h2.
Qed.
Lemma l1 : s1 -> False.
Proof.
 intros h0.
 assert (h1 := l2 h0).
 assert (h2 := l10 h0).
 refine (simplify (Tatom false (Abnd 0%nat i6)) Tfalse (Abnd 0%nat i6) (List.cons r1 List.nil) h2 h1 _) ; finalize.
Qed.
End Generated_by_Gappa.
