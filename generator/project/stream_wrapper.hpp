#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/described_modules.hpp"
#include "generator/project/project.hpp"

namespace mixcmp::project {

/// A port of the top, seen as fields. A port of a system has one field for each lane or group of
/// lanes; one of a refetch stream has one for each reference, then one for each lane of the second
/// tier. A port of a pairwise engine has one field for each stream of reports, or belongs to no
/// vector of streams.
struct FieldPort {
  const emit::SignaturePort* port;
  int count = 0;           ///< fields
  bool is_single = false;  ///< in no vector of streams: the port keeps its name

  int field_width() const { return port->width / count; }
  /// The name of the port for field k: "s_axis_3_tdata", "comparisons_3".
  std::string field_name(int k) const;
};

/// Whether the top has vectors of streams, around which there is a wrapper: that of a system, or of
/// a pairwise engine with several streams of reports.
bool has_stream_wrapper(const emit::Signature& signature);

/// A module around the top that has ports of their own for each lane, or group of lanes in lock
/// step, and each refetch stream or, around a pairwise engine, for each stream of reports.
emit::Described stream_wrapper(const ProjectSpec& spec);

}  // namespace mixcmp::project
