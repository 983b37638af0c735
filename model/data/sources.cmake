target_sources(mixcmp_model PRIVATE
  data/comparisons.cpp
  data/csv.cpp
  data/load.cpp
  data/npy.cpp
  data/npy_header.cpp
  data/number.cpp
  data/pdb.cpp
  data/uniform_spheres.cpp
  data/van_der_waals.cpp
)
