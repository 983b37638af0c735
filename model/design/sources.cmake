target_sources(mixcmp_model PRIVATE
  design/design.cpp
  design/group_names.cpp
  design/slots.cpp
)
