#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <exception>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "generator/faces/api/mixcmp.hpp"

/// The extension module mixcmp._core: the public C++ library with NumPy arrays. The package in the
/// folder mixcmp wraps it for users of Python.
namespace mixcmp::python {
namespace {

namespace py = pybind11;

/// Rows of doubles, copied and converted where the caller's array is of another type or layout.
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::span<const double> span_of(const Rows& rows) {
  return {rows.data(), static_cast<std::size_t>(rows.size())};
}

/// Runs a function that takes long while other Python threads run.
template <class Function>
auto without_gil(const Function& function) {
  const py::gil_scoped_release released;
  return function();
}

py::array_t<std::uint8_t> bits_of(const std::vector<api::Answer>& answers) {
  py::array_t<std::uint8_t> bits(static_cast<py::ssize_t>(answers.size()));
  std::uint8_t* out = bits.mutable_data();
  for (const api::Answer answer : answers) *out++ = answer.bits();
  return bits;
}

/// A callback that may raise. Its exceptions are reported as unraisable: it is called from threads
/// of the library, where nobody could catch them.
template <class... Arguments>
std::function<void(Arguments...)> guarded(const std::function<void(Arguments...)>& progress) {
  if (!progress) return {};
  return [progress](Arguments... arguments) {
    try {
      progress(arguments...);
    } catch (py::error_already_set& raised) {
      const py::gil_scoped_acquire held;
      raised.discard_as_unraisable("progress of mixcmp");
    }
  };
}

py::array_t<double> operands_of(const api::Scene& scene, std::uint64_t first, std::size_t count) {
  const std::vector<double> rows = without_gil([&] { return scene.operands(first, count); });
  const auto width = static_cast<py::ssize_t>(scene.inputs().size());
  py::array_t<double> array({static_cast<py::ssize_t>(count), width});
  std::copy(rows.begin(), rows.end(), array.mutable_data());
  return array;
}

/// The values of the verdicts; -1 where a true verdict is not known.
py::array_t<std::int8_t> true_verdicts_of(const api::Scene& scene, const Rows& rows) {
  const auto verdicts = without_gil([&] { return scene.true_verdicts(span_of(rows)); });
  py::array_t<std::int8_t> array(static_cast<py::ssize_t>(verdicts.size()));
  std::int8_t* out = array.mutable_data();
  for (const auto& verdict : verdicts) *out++ = verdict ? static_cast<std::int8_t>(*verdict) : -1;
  return array;
}

api::Profile profile_of(const api::Scene& scene, std::optional<int> first, std::optional<int> last,
                        std::uint64_t samples, unsigned threads, const api::Progress& progress) {
  const api::ProfileOptions options{.first_precision = first,
                                    .last_precision = last,
                                    .error_samples = samples,
                                    .threads = threads,
                                    .progress = guarded(progress)};
  return without_gil([&] { return api::profile(scene, options); });
}

void add_scene(py::module_& module) {
  using api::Scene;
  py::class_<Scene>(module, "Scene")
      .def_static("from_file", &Scene::from_file)
      .def_static("from_text", &Scene::from_text)
      .def("with_operands",
           [](const Scene& scene, const Rows& rows) { return scene.with_operands(span_of(rows)); })
      .def_property_readonly("name", &Scene::name)
      .def_property_readonly("inputs", &Scene::inputs)
      .def_property_readonly("f", &Scene::f)
      .def_property_readonly("g", &Scene::g)
      .def_property_readonly("reference_format", &Scene::reference_format)
      .def_property_readonly("reduced_format", &Scene::reduced_format)
      .def_property_readonly("notes", &Scene::notes)
      .def_property_readonly("comparison_count", &Scene::comparison_count)
      .def("operands", operands_of)
      .def("true_verdicts", true_verdicts_of)
      .def("summary", &Scene::summary)
      .def("summary_json", &Scene::summary_json);
}

void add_lane_group(py::module_& module) {
  py::class_<api::LaneGroup>(
      module, "LaneGroup",
      "Lanes of one kind: format, count, latency_cycles, certified, and decision in words.")
      .def_readonly("format", &api::LaneGroup::format)
      .def_readonly("count", &api::LaneGroup::count)
      .def_readonly("latency_cycles", &api::LaneGroup::latency_cycles)
      .def_readonly("certified", &api::LaneGroup::certified)
      .def_readonly("decision", &api::LaneGroup::decision);
}

void add_system(py::module_& module) {
  using api::System;
  py::class_<System>(module, "System")
      .def(py::init<const api::Scene&>())
      .def_property_readonly("top", &System::top)
      .def_property_readonly("certified", &System::certified)
      .def_property_readonly("lane_count", &System::lane_count)
      .def_property_readonly("reference_count", &System::reference_count)
      .def_property_readonly("lanes", &System::lanes)
      .def_property_readonly("notes", &System::notes)
      .def("emulate",
           [](const System& system, const Rows& rows, std::size_t group) {
             return bits_of(without_gil([&] { return system.emulate(span_of(rows), group); }));
           })
      .def("evaluate",
           [](const System& system, const Rows& rows, std::size_t group) {
             return bits_of(without_gil([&] { return system.evaluate(span_of(rows), group); }));
           })
      .def("files",
           [](const System& system) {
             py::dict files;
             for (const api::File& file : system.files()) files[py::str(file.name)] = file.text;
             return files;
           })
      .def("write", &System::write);
}

void add_profile(py::module_& module) {
  py::class_<api::Counts>(module, "Counts",
                          "Counts of all comparisons in lanes of one kind at one precision.")
      .def_readonly("precision", &api::Counts::precision)
      .def_readonly("undecided", &api::Counts::undecided)
      .def_readonly("wrong", &api::Counts::wrong)
      .def_readonly("wrong_by_lane", &api::Counts::wrong_by_lane);
  py::class_<api::Scheme>(module, "Scheme", "One kind of lane and its counts.")
      .def_readonly("name", &api::Scheme::name)
      .def_readonly("certified", &api::Scheme::certified)
      .def_readonly("counts", &api::Scheme::counts);
  py::class_<api::RelativeErrors>(module, "RelativeErrors", "Relative errors at one precision.")
      .def_readonly("precision", &api::RelativeErrors::precision)
      .def_readonly("f", &api::RelativeErrors::f)
      .def_readonly("g", &api::RelativeErrors::g)
      .def_readonly("f_bound", &api::RelativeErrors::f_bound)
      .def_readonly("g_bound", &api::RelativeErrors::g_bound);
  py::class_<api::Profile>(module, "Profile", "The counts of a profile.")
      .def_readonly("comparisons", &api::Profile::comparisons)
      .def_readonly("reference_wrong", &api::Profile::reference_wrong)
      .def_readonly("undetermined", &api::Profile::undetermined)
      .def_readonly("errors", &api::Profile::errors)
      .def_readonly("schemes", &api::Profile::schemes);
  module.def("profile", profile_of);
}

api::Plan plan_of(const api::Scene& scene, const std::filesystem::path& table,
                  std::optional<int> first, std::optional<int> last, std::optional<double> lane_mhz,
                  std::optional<double> reference_mhz, const std::filesystem::path& plan_file,
                  const api::Progress& progress) {
  const api::PlanOptions options{.table = table,
                                 .first_precision = first,
                                 .last_precision = last,
                                 .lane_mhz = lane_mhz,
                                 .reference_mhz = reference_mhz,
                                 .plan_file = plan_file,
                                 .progress = guarded(progress)};
  return without_gil([&] { return api::plan(scene, options); });
}

void add_plan(py::module_& module) {
  py::class_<api::PlanPoint>(
      module, "PlanPoint",
      "The best plan at one precision: lanes is p_L, 0 where nothing fits; references p_H.")
      .def_readonly("precision", &api::PlanPoint::precision)
      .def_readonly("lanes", &api::PlanPoint::lanes)
      .def_readonly("references", &api::PlanPoint::references)
      .def_readonly("clock_mhz", &api::PlanPoint::clock_mhz)
      .def_readonly("recomputation_rate", &api::PlanPoint::recomputation_rate)
      .def_readonly("throughput_per_s", &api::PlanPoint::throughput_per_s)
      .def_readonly("kinds", &api::PlanPoint::kinds);
  py::class_<api::Plan>(module, "Plan",
                        "The plans of a scene: best, points by precision, baseline_per_s of "
                        "references alone, notes, text as the program prints it, toml.")
      .def_readonly("best", &api::Plan::best)
      .def_readonly("points", &api::Plan::points)
      .def_readonly("baseline_per_s", &api::Plan::baseline_per_s)
      .def_readonly("notes", &api::Plan::notes)
      .def_readonly("text", &api::Plan::text)
      .def_readonly("toml", &api::Plan::toml);
  module.def("plan", plan_of);
}

api::Verification verification_of(const api::Scene& scene, api::Simulator simulator,
                                  api::Traffic traffic, api::Truth truth,
                                  std::optional<std::uint64_t> first,
                                  std::optional<std::uint64_t> sample,
                                  std::optional<std::uint64_t> only, std::uint64_t seed, int resets,
                                  int jobs, bool find_counterexample,
                                  const std::filesystem::path& work,
                                  const std::function<void(const std::string&)>& progress) {
  const api::VerifyOptions options{.simulator = simulator,
                                   .traffic = traffic,
                                   .truth = truth,
                                   .first = first,
                                   .sample = sample,
                                   .only = only,
                                   .seed = seed,
                                   .resets = resets,
                                   .jobs = jobs,
                                   .find_counterexample = find_counterexample,
                                   .work = work,
                                   .progress = guarded(progress)};
  return without_gil([&] { return api::verify(scene, options); });
}

void add_verify(py::module_& module) {
  py::enum_<api::Simulator>(module, "Simulator")
      .value("verilator", api::Simulator::verilator)
      .value("icarus", api::Simulator::icarus);
  py::enum_<api::Traffic>(module, "Traffic")
      .value("full_rate", api::Traffic::full_rate)
      .value("stressed", api::Traffic::stressed);
  py::enum_<api::Truth>(module, "Truth")
      .value("off", api::Truth::off)
      .value("recomputed", api::Truth::recomputed)
      .value("all", api::Truth::all);
  py::class_<api::Verification>(module, "Verification", "The findings of a simulation.")
      .def_readonly("passed", &api::Verification::passed)
      .def_readonly("comparisons", &api::Verification::comparisons)
      .def_readonly("recomputations", &api::Verification::recomputations)
      .def_readonly("undecided", &api::Verification::undecided)
      .def_readonly("mismatches", &api::Verification::mismatches)
      .def_readonly("violations", &api::Verification::violations)
      .def_readonly("not_done", &api::Verification::not_done)
      .def_readonly("text", &api::Verification::text)
      .def_readonly("json", &api::Verification::json);
  module.def("verify", verification_of);
}

/// Raises mixcmp.Error, made by the package from the parts of an api::Error.
void raise_error(const api::Error& error) {
  const api::Error::Details& details = error.details();
  const py::object type = py::module_::import("mixcmp._error").attr("Error");
  const py::object raised =
      type(error.what(), py::arg("file") = details.file, py::arg("line") = details.line,
           py::arg("field") = details.field, py::arg("message") = details.message,
           py::arg("received") = details.received, py::arg("accepted") = details.accepted,
           py::arg("missing_tool") = details.missing_tool);
  PyErr_SetObject(type.ptr(), raised.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const api::Error& error) {
    raise_error(error);
  }
}

}  // namespace

void define(py::module_& module) {
  py::register_local_exception_translator(translate);
  module.attr("version") = api::version();
  add_scene(module);
  add_lane_group(module);
  add_system(module);
  add_profile(module);
  add_plan(module);
  add_verify(module);
}

}  // namespace mixcmp::python

PYBIND11_MODULE(_core, module) {
  mixcmp::python::define(module);
}
