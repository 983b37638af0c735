target_sources(mixcmp_model PRIVATE
  golden/arithmetic.cpp
  golden/big_float.cpp
  golden/bound_arithmetic.cpp
  golden/enclosure.cpp
  golden/encoding.cpp
  golden/evaluate.cpp
  golden/separation.cpp
  golden/true_values.cpp
)
