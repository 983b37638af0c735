#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/synthesis/components/component_list.hpp"
#include "generator/synthesis/components/unit_library.hpp"
#include "model/base/common/memo.hpp"
#include "model/cost/devices/device.hpp"
#include "model/cost/measured/measurement.hpp"

namespace mixcmp::components {

/// Predicts areas of components on one device: the sum of the areas of their parts, as a library
/// has them (units::UnitAreas).
class AreaPredictor {
public:
  /// An error names a library that cannot be read.
  static Result<AreaPredictor> make(const devices::Device& device);

  /// The area that `characterise` would measure; none if the library lacks a template.
  /// Threads may ask at the same time.
  std::optional<devices::Area> of(const Component& component) const;

  /// Whether the device's family has no library and another one stands in.
  bool is_rough() const { return library_.stands_in; }
  /// The templates that the library lacked so far.
  const std::set<std::string>& unknown() const { return used_->unknown; }
  /// The templates used so far that have changed since the library was measured.
  const std::set<std::string>& outdated() const { return used_->outdated; }

private:
  /// The instances that components had so far.
  struct Used {
    Memo<std::string, std::optional<devices::Area>> areas;  ///< by name
    std::mutex mutex;                                       ///< guards the members below
    std::set<std::string> unknown, outdated, seen;          ///< templates
  };

  AreaPredictor(UnitLibrary library, const devices::Device& device);

  std::optional<devices::Area> of(const Part& part) const;
  std::optional<devices::Area> of(const rtl::TemplateInstance& instance) const;

  void note(const std::string& module, bool is_known) const;
  devices::Area as_on_device(devices::Area area) const;

  UnitLibrary library_;
  devices::Device device_;
  bool packs_;  ///< Yosys packs registers and sums into multipliers (component_parts.hpp)
  std::unique_ptr<Used> used_;
};

/// The device's LUTs, counted in LUTs of six inputs. LUTs of two families differ in more than their
/// inputs, so this compares families only roughly.
double six_input_luts(const devices::Device& device);

/// The area of a component of a scene; none if it cannot be predicted. Called from several threads.
using PredictedArea =
    std::function<std::optional<devices::Area>(const Component&, const scene::Scene&)>;

/// The components of the maker's scene that a query asks for, with predicted areas and no clocks:
/// no tool runs. Those without a predicted area are left out.
Result<measured::Characterisation> predict_table(const PredictedArea& area_of,
                                                 ComponentMaker& maker,
                                                 const ComponentQuery& query);

/// The areas that are predicted for the rows of a scene's table, in their order; none where the
/// library lacks a template, and for rows of a vendor's report, which count otherwise. `data` may
/// be null.
std::vector<std::optional<devices::Area>> predicted_areas(AreaPredictor& predictor,
                                                          const measured::Characterisation& table,
                                                          const scene::Scene& scene,
                                                          const data::Comparisons* data);

}  // namespace mixcmp::components
