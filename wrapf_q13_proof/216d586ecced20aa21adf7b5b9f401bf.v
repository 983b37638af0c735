Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x12 : R.
Variable _x3 : R.
Notation _c := ((_x12 - _x3)%R).
Variable _e12 : R.
Notation r6 := ((_x12 - _e12)%R).
Variable _e3 : R.
Notation r8 := ((_x3 - _e3)%R).
Notation _t := ((r6 - r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r10 := ((_e12 - _e3)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (3) (-12).
Definition f2 := Float2 (25733) (-12).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x12 i1). (* BND(x12, [0.000732422, 6.28247]) *)
Definition f3 := Float2 (-691652714369016416898719383064726288889) (-140).
Definition f4 := Float2 (716487131442741160086630612514586357837) (-140).
Definition i2 := makepairF f3 f4.
Notation p2 := (BND _e12 i2). (* BND(e12, [-0.000496236, 0.000514054]) *)
Definition s4 := (p1 /\ p2).
Definition f5 := Float2 (3217) (-10).
Definition i3 := makepairF f5 f5.
Notation p3 := (BND _x3 i3). (* BND(x3, [3.1416, 3.1416]) *)
Definition s3 := (s4 /\ p3).
Definition f6 := Float2 (1552151067107796449244451840616254309) (-137).
Definition f7 := Float2 (3104302134215592898488903681232508619) (-138).
Definition i4 := makepairF f6 f7.
Notation p4 := (BND _e3 i4). (* BND(e3, [8.90891e-06, 8.90891e-06]) *)
Definition s2 := (s3 /\ p4).
Definition f8 := Float2 (-12865) (-12).
Definition f9 := Float2 (12865) (-12).
Definition i5 := makepairF f8 f9.
Notation p5 := (BND _c i5). (* BND(c, [-3.14087, 3.14087]) *)
Definition s6 := (not p5).
Definition f10 := Float2 (-704069922905878788492674997789656323365) (-140).
Definition f11 := Float2 (704069922905878788492674997789656323365) (-140).
Definition i6 := makepairF f10 f11.
Notation p6 := (BND r1 i6). (* BND(c - t, [-0.000505145, 0.000505145]) *)
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
Lemma l5 : s1 -> p1 (* BND(x12, [0.000732422, 6.28247]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x3, [3.1416, 3.1416]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (sub _x12 _x3 i1 i3 i5 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [-3.14087, 3.14087]) *).
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
Notation p7 := (r1 = r10). (* EQL(c - t, e12 - e3) *)
Lemma t2 : p7.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* EQL(c - t, e12 - e3) *).
Proof.
 intros h0.
 apply t2.
Qed.
Notation p8 := (BND r10 i6). (* BND(e12 - e3, [-0.000505145, 0.000505145]) *)
Lemma l13 : s1 -> p2 (* BND(e12, [-0.000496236, 0.000514054]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma l14 : s1 -> p4 (* BND(e3, [8.90891e-06, 8.90891e-06]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p2 -> p4 -> p8.
Proof.
 intros h0 h1.
 refine (sub _e12 _e3 i2 i4 i6 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(e12 - e3, [-0.000505145, 0.000505145]) *).
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
Lemma l10 : s1 -> p6 (* BND(c - t, [-0.000505145, 0.000505145]) *).
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
