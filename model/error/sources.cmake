target_sources(mixcmp_model PRIVATE
  error/lane.cpp
  error/profiled_error.cpp
  error/relative_bound.cpp
)
