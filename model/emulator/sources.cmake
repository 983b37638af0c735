target_sources(mixcmp_model PRIVATE
  emulator/emulator.cpp
  emulator/operand.cpp
)
