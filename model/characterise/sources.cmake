target_sources(mixcmp_model PRIVATE
  characterise/job_hash.cpp
  characterise/job_runner.cpp
  characterise/logic_cells.cpp
  characterise/mapped_area.cpp
  characterise/measurement.cpp
  characterise/register_wrapper.cpp
  characterise/router.cpp
  characterise/signal_gate.cpp
  characterise/sqlite.cpp
  characterise/static_timing.cpp
  characterise/store.cpp
  characterise/synthesis.cpp
  characterise/table.cpp
  characterise/table_reader.cpp
  characterise/tools.cpp
)
