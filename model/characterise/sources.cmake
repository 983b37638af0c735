target_sources(mixcmp_model PRIVATE
  characterise/logic_cells.cpp
  characterise/mapped_area.cpp
  characterise/register_wrapper.cpp
  characterise/router.cpp
  characterise/static_timing.cpp
  characterise/synthesis.cpp
  characterise/tools.cpp
)
