target_sources(mixcmp_model PRIVATE
  scene/data_section.cpp
  scene/groups.cpp
  scene/input_ranges.cpp
  scene/load_comparisons.cpp
  scene/plan.cpp
  scene/reduced_section.cpp
  scene/scene.cpp
  scene/section.cpp
  scene/settings.cpp
  scene/spelling.cpp
  scene/summary.cpp
  scene/summary_json.cpp
  scene/summary_print.cpp
  scene/system_section.cpp
  scene/variant.cpp
  scene/variant_check.cpp
)
