target_sources(mixcmp_generator PRIVATE
  software/baseline.cpp
  software/float_filter.cpp
  software/program.cpp
  software/report.cpp
  software/source.cpp
)
mixcmp_embed(TARGET mixcmp_generator NAMESPACE mixcmp::gen SYMBOL software_program
             FILES software/program/arithmetic.hpp software/program/harness.hpp)
