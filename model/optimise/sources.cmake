target_sources(mixcmp_model PRIVATE
  optimise/exploration.cpp
  optimise/figures.cpp
  optimise/optimise.cpp
  optimise/plan.cpp
  optimise/published.cpp
  optimise/rates.cpp
  optimise/report.cpp
  optimise/tables.cpp
)
