target_sources(mixcmp_model PRIVATE
  data/column_names.cpp
  data/comparisons.cpp
  data/csv.cpp
  data/dyadic.cpp
  data/input_sources.cpp
  data/near_tie.cpp
  data/npy.cpp
  data/npy_header.cpp
  data/number.cpp
  data/pairing.cpp
  data/pdb.cpp
  data/sphere_family.cpp
  data/sphere_pair_maker.cpp
  data/uniform_spheres.cpp
  data/van_der_waals.cpp
)
