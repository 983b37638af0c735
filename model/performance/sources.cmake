target_sources(mixcmp_model PRIVATE performance/performance.cpp)
