target_sources(mixcmp_model PRIVATE
  performance/performance.cpp
  performance/streams.cpp
)
