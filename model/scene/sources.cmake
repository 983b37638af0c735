target_sources(mixcmp_model PRIVATE
  scene/input_ranges.cpp
  scene/scene.cpp
  scene/section.cpp
  scene/settings.cpp
  scene/spelling.cpp
  scene/summary.cpp
  scene/summary_print.cpp
)
