#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mixcmp::data {

/// The van der Waals radius of an element ("C", "SE", ...; any case) in angstrom, as decimal text.
/// Sources: Bondi 1964 (J. Phys. Chem. 68, 441) for most; Mantina et al. 2009 (J. Phys. Chem. A
/// 113, 5806) for B, Al, Ca; Alvarez 2013 (Dalton Trans. 42, 8617) for Mn, Fe, Co, Mo. D is H.
std::optional<std::string_view> van_der_waals_radius(std::string_view element);

/// Every element with a radius, for error messages.
std::string known_elements();

}  // namespace mixcmp::data
