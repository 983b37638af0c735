target_sources(mixcmp_model PRIVATE expression/graph.cpp)
