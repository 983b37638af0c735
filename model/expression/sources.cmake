target_sources(mixcmp_model PRIVATE
  expression/combined_graph.cpp
  expression/graph.cpp
  expression/literal.cpp
  expression/name.cpp
  expression/parser.cpp
  expression/syntax.cpp
  expression/text.cpp
  expression/typed_graph.cpp
)
