target_sources(mixcmp_model PRIVATE
  error/certified_lane.cpp
  error/combined_lane.cpp
  error/constant_bound.cpp
  error/error_analysis.cpp
  error/exactness.cpp
  error/exponent_range.cpp
  error/hazards.cpp
  error/lane.cpp
  error/bound_builder.cpp
  error/bound_graph.cpp
  error/profiled_error.cpp
  error/range_analysis.cpp
  error/range_check.cpp
  error/relative_bound.cpp
  error/sign.cpp
)
