target_sources(mixcmp_model PRIVATE
  profile/bound_envelope.cpp
  profile/candidates.cpp
  profile/envelope.cpp
  profile/error_worker.cpp
  profile/errors.cpp
  profile/node_magnitudes.cpp
  profile/operands.cpp
  profile/rate_worker.cpp
  profile/rates.cpp
  profile/stage.cpp
  profile/systems.cpp
  profile/threshold.cpp
  profile/workers.cpp
)
