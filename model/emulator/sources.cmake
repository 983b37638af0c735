target_sources(mixcmp_model PRIVATE
  emulator/decision_plan.cpp
  emulator/emulator.cpp
  emulator/execution.cpp
  emulator/kernels.cpp
  emulator/operand.cpp
  emulator/plan.cpp
  emulator/reference_contest.cpp
  emulator/safe_operands.cpp
)
target_link_libraries(mixcmp_model PRIVATE hwy::hwy)
