target_sources(mixcmp_model PRIVATE
  proof/choice_lemmas.cpp
  proof/claims.cpp
  proof/cone.cpp
  proof/cone_script.cpp
  proof/gappa.cpp
  proof/lane_proof.cpp
  proof/provers.cpp
  proof/relative_proof.cpp
  proof/report.cpp
  proof/script.cpp
  proof/zero_patterns.cpp
)
