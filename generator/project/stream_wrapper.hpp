#pragma once

#include <string>
#include <vector>

#include "generator/project/project.hpp"
#include "generator/rtl/module.hpp"

namespace mixcmp::project {

/// A port of the system's top that has one field for each lane or, of a refetch stream, for each
/// reference.
struct FieldPort {
  const emit::SignaturePort* port;
  int count = 0;  ///< fields

  int field_width() const { return port->width / count; }
  /// The port of field k alone: "s_axis_3_tdata", "comparisons_3".
  std::string field_name(int k) const;
};

/// The ports of the system's top but aclk and aresetn.
std::vector<FieldPort> field_ports(const emit::Signature& signature);

/// The wrapper's name; there is one where the scene has no engine, whose streams are single.
std::string stream_wrapper_name(const emit::Signature& signature);

/// A module around the system that has ports of their own for each lane and each refetch stream.
rtl::Module stream_wrapper(const ProjectSpec& spec);

}  // namespace mixcmp::project
