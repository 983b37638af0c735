target_sources(mixcmp_model PRIVATE
  profile/bound_envelope.cpp
  profile/candidates.cpp
  profile/check.cpp
  profile/cost_model.cpp
  profile/envelope.cpp
  profile/error_worker.cpp
  profile/errors.cpp
  profile/figures.cpp
  profile/node_magnitudes.cpp
  profile/operands.cpp
  profile/rate_worker.cpp
  profile/rates.cpp
  profile/report.cpp
  profile/stage.cpp
  profile/systems.cpp
  profile/threshold.cpp
  profile/trade.cpp
  profile/trade_report.cpp
  profile/workers.cpp
)
# Neither changes a result; without them g++ does not vectorise conditions and square roots.
set_source_files_properties(
  ${CMAKE_CURRENT_LIST_DIR}/bound_envelope.cpp ${CMAKE_CURRENT_LIST_DIR}/envelope.cpp
  ${CMAKE_CURRENT_LIST_DIR}/stage.cpp ${CMAKE_CURRENT_LIST_DIR}/threshold.cpp
  PROPERTIES COMPILE_OPTIONS "-fno-trapping-math;-fno-math-errno")
