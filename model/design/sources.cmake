target_sources(mixcmp_model PRIVATE
  design/design.cpp
  design/engine_data.cpp
  design/group_names.cpp
  design/slots.cpp
)
