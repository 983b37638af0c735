target_sources(mixcmp_model PRIVATE
  devices/area.cpp
  devices/device.cpp
  devices/device_file.cpp
)

# In the order in which they are listed to the user: the paper's first.
mixcmp_embed(TARGET mixcmp_model NAMESPACE mixcmp::model SYMBOL device_files FILES
  devices/virtex5-lx330t.toml
  devices/virtex6-lx760.toml
  devices/artix7-200t.toml
  devices/ultrascale+-vu9p.toml
  devices/ecp5-85k.toml
  devices/ice40-hx8k.toml
  devices/ice40-up5k.toml
)
