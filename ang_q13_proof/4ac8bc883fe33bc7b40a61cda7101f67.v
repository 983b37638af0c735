Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x2 : R.
Variable _x37 : R.
Notation _c := ((_x2 - _x37)%R).
Variable _e2 : R.
Notation r6 := ((_x2 - _e2)%R).
Variable _e37 : R.
Notation r8 := ((_x37 - _e37)%R).
Notation _t := ((r6 - r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r10 := ((_e2 - _e37)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (3217) (-11).
Definition i1 := makepairF f1 f1.
Notation p1 := (BND _x2 i1). (* BND(x2, [1.5708, 1.5708]) *)
Definition f2 := Float2 (13980533929816739769045285477420835621039767125767051) (-191).
Definition f3 := Float2 (3495133482454184942261321369355208905259941781441763) (-189).
Definition i2 := makepairF f2 f3.
Notation p2 := (BND _e2 i2). (* BND(e2, [4.45446e-06, 4.45446e-06]) *)
Definition s4 := (p1 /\ p2).
Definition f4 := Float2 (-12869) (-13).
Definition f5 := Float2 (12869) (-13).
Definition i3 := makepairF f4 f5.
Notation p3 := (BND _x37 i3). (* BND(x37, [-1.57092, 1.57092]) *)
Definition s3 := (s4 /\ p3).
Definition f6 := Float2 (-61047440385433288710221545355215841979774675184710981077745) (-207).
Definition f7 := Float2 (61047440385433288710221545355215841979774675184710981077745) (-207).
Definition i4 := makepairF f6 f7.
Notation p4 := (BND _e37 i4). (* BND(e37, [-0.000296796, 0.000296796]) *)
Definition s2 := (s3 /\ p4).
Definition f8 := Float2 (-1) (-13).
Definition f9 := Float2 (25737) (-13).
Definition i5 := makepairF f8 f9.
Notation p5 := (BND _c i5). (* BND(c, [-0.00012207, 3.14172]) *)
Definition s6 := (not p5).
Definition f10 := Float2 (-60131212113808818852717393526167590096514213006356711623409) (-207).
Definition f11 := Float2 (61963668657057758567725697184264093863035137363065250597617) (-207).
Definition i6 := makepairF f10 f11.
Notation p6 := (BND r1 i6). (* BND(c - t, [-0.000292342, 0.000301251]) *)
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
Lemma l5 : s1 -> p1 (* BND(x2, [1.5708, 1.5708]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x37, [-1.57092, 1.57092]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (sub _x2 _x37 i1 i3 i5 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [-0.00012207, 3.14172]) *).
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
Notation p7 := (r1 = r10). (* EQL(c - t, e2 - e37) *)
Lemma t2 : p7.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* EQL(c - t, e2 - e37) *).
Proof.
 intros h0.
 apply t2.
Qed.
Notation p8 := (BND r10 i6). (* BND(e2 - e37, [-0.000292342, 0.000301251]) *)
Lemma l13 : s1 -> p2 (* BND(e2, [4.45446e-06, 4.45446e-06]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma l14 : s1 -> p4 (* BND(e37, [-0.000296796, 0.000296796]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p2 -> p4 -> p8.
Proof.
 intros h0 h1.
 refine (sub _e2 _e37 i2 i4 i6 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(e2 - e37, [-0.000292342, 0.000301251]) *).
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
Lemma l10 : s1 -> p6 (* BND(c - t, [-0.000292342, 0.000301251]) *).
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
