target_sources(mixcmp_model PRIVATE
  design/design.cpp
  design/slots.cpp
)
