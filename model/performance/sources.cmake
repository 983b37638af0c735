target_sources(mixcmp_model PRIVATE)
