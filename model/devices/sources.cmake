target_sources(mixcmp_model PRIVATE
  devices/area.cpp
)
