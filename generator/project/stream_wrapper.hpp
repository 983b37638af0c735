#pragma once

#include <string>
#include <vector>

#include "generator/emit/described_modules.hpp"
#include "generator/project/project.hpp"

namespace mixcmp::project {

/// A port of the top. Of a system it has one field for each lane or group of lanes or, of a refetch
/// stream, for each reference; of a pairwise engine one for each stream of reports, or is no vector
/// of streams.
struct FieldPort {
  const emit::SignaturePort* port;
  int count = 0;           ///< fields
  bool is_single = false;  ///< of no stream beside which there are others: it keeps its name

  int field_width() const { return port->width / count; }
  /// The port of field k alone: "s_axis_3_tdata", "comparisons_3".
  std::string field_name(int k) const;
};

/// Whether the top has vectors of streams, around which there is a wrapper: that of a system, or of
/// a pairwise engine with several streams of reports.
bool has_stream_wrapper(const emit::Signature& signature);

/// A module around the top that has ports of their own for each lane, or group of lanes in lock
/// step, and each refetch stream or, around a pairwise engine, for each stream of reports.
emit::Described stream_wrapper(const ProjectSpec& spec);

}  // namespace mixcmp::project
