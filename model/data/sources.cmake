target_sources(mixcmp_model PRIVATE
  data/comparisons.cpp
)
