#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/base/common/place.hpp"
#include "model/comparison/data/column_names.hpp"
#include "model/comparison/data/pairing.hpp"
#include "model/comparison/data/uniform_table.hpp"

namespace mixcmp::data {

/// The section [data] of a scene: the numbers that are compared (docs/scene_file.md).
struct DataSpec {
  std::string items;           ///< a generator's name, or empty when a file is named
  std::string family;          ///< one of sphere_family_names(); only for items "sphere_family"
  std::filesystem::path file;  ///< .pdb, .csv or .npy; relative to the scene file
  std::int64_t count = 8192;
  std::int64_t with_count = 16;  ///< of items "uniform": rows of the second table
  double side = 100;
  double radius_max = 25;
  std::uint64_t seed = 1;
  Pairing pairing = Pairing::rows;
  std::filesystem::path with;        ///< the second table's file, if the pairing has one
  std::vector<ColumnNames> columns;  ///< the names that the scene gives to columns
  std::vector<ColumnNames> with_columns;
  /// The numbers that items "uniform" may draw for each of the graph's inputs; empty elsewhere.
  std::vector<UniformNumbers> numbers;
  /// The place of each given key, and of [data] itself under "", for errors that are found when
  /// data are read.
  std::map<std::string, Place> places;
};

/// The name of the table `which`, 0 or 1, in messages: its file's or its generator's.
std::string table_name(const DataSpec& data, std::size_t which);

}  // namespace mixcmp::data
