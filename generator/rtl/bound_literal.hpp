#pragma once

#include <gmpxx.h>

#include "model/error/bound_graph.hpp"

namespace mixcmp::gen {

/// A constant bound >= 0, rounded up into the format and packed (rules:
/// model/error/bound_graph.hpp). Whole-number arithmetic, so that the golden model, which goes
/// through MPFR, can judge it.
model::Bits bound_literal(model::BoundFormat format, const mpq_class& value);

}  // namespace mixcmp::gen
