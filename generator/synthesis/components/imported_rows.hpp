#pragma once

#include <vector>

#include "generator/synthesis/characterise/vendor_report.hpp"
#include "generator/synthesis/components/component_maker.hpp"
#include "model/design/design.hpp"

namespace mixcmp::components {

/// The reports of one compilation of a generated system.
struct ImportedReports {
  characterise::VendorReport areas;
  std::optional<characterise::VendorReport> timing;  ///< of the same tool, design and part
  std::string part;                                  ///< "xc7a200tfbg676-2"
};

/// A table's row from the instances of one component in a system.
struct ImportedRow {
  measured::Measurement row;
  int instances = 0;
};

/// Makes rows of the components that a system of `scene` has: lanes, scoreboards, references, the
/// crossbar. An area is the mean over the component's instances, rounded up, so that a plan counts
/// their total area. The crossbar's share of a reference is that of the lanes which it serves. The
/// clock of every row is that of the whole system. Errors name the report and its line, a lane that
/// no row can name, or an engine, which has no such components. A crossbar of more lanes per
/// reference than `measured_ports` has no row.
Result<std::vector<ImportedRow>> imported_rows(const scene::Scene& scene,
                                               const data::Comparisons* data,
                                               const design::Design& design,
                                               const ImportedReports& reports);

}  // namespace mixcmp::components
