#include "python/module/outcome.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "apps/cli/result_files.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/report/report.hpp"
#include "python/module/job.hpp"

namespace liesl::python {

std::vector<std::string> Outcome::names() const {
  std::vector<std::string> out;
  for (const output::DataSet& set : tree_.sets) out.push_back(set.name.substr(1));
  return out;
}

const output::DataSet* Outcome::find(const std::string& name) const {
  for (const output::DataSet& set : tree_.sets)
    if (set.name.compare(1, std::string::npos, name) == 0) return &set;
  return nullptr;
}

std::vector<std::pair<std::string, std::string>> Outcome::attributes(
    const std::string& group) const {
  for (const output::DataGroup& g : tree_.groups)
    if (g.name.compare(1, std::string::npos, group) == 0) return g.attributes;
  return {};
}

void Outcome::save(const std::filesystem::path& target, bool overwrite, bool page) const {
  output::AtomicFolder folder(target, overwrite);
  write(folder.path());
  const auto named = std::filesystem::absolute(target).lexically_normal();
  if (page)
    output::write_file(folder.path() / report::kReport,
                       report::page_of(folder.path(), named.filename().string()));
  folder.commit();
}

std::string RunResult::summary() const { return output::to_json(outcome_.summary).dump(); }
void RunResult::write(const std::filesystem::path& folder) const { write_run(folder, outcome_); }

std::string MotionResult::summary() const {
  return output::to_json(motion_->outcome().summary).dump();
}
void MotionResult::write(const std::filesystem::path& folder) const {
  write_run(folder, motion_->outcome());
}

py::array view(const double* data, const std::vector<std::size_t>& shape, const py::object& owner) {
  py::array array(py::dtype::of<double>(), shape, data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array owned(std::vector<double> numbers, const std::vector<std::size_t>& shape) {
  auto* kept = new std::vector<double>(std::move(numbers));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<double>*>(p); });
  return view(kept->data(), shape, owner);
}

namespace {

/// A view of a data set, or a list of texts; None if there is none of that name.
py::object array_of(const py::object& self, const std::string& name) {
  const output::DataSet* set = self.cast<const Outcome&>().find(name);
  if (!set) return py::none();
  if (const auto* numbers = std::get_if<std::span<const double>>(&set->values))
    return view(numbers->data(), set->shape, self);
  if (const auto* texts = std::get_if<std::vector<std::string>>(&set->values))
    return py::cast(*texts);
  py::array integers(py::dtype::of<int>(), set->shape,
                     std::get<std::vector<int>>(set->values).data(), self);
  integers.attr("setflags")(py::arg("write") = false);
  return integers;
}

/// Numbers by response, n x C; None: zero.
std::vector<std::vector<double>> weights_of(const py::list& given) {
  std::vector<std::vector<double>> out;
  for (const py::handle& item : given) {
    auto& numbers = out.emplace_back();
    if (item.is_none()) continue;
    const auto array = item.cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    numbers.assign(array.data(), array.data() + array.size());
  }
  return out;
}

/// dy/dp of every response, n x C x P.
py::list derivatives_of(const std::shared_ptr<MotionResult>& result) {
  const DifferentiableMotion& motion = result->motion();
  auto all =
      run_job([result](const Stop& stop) { return result->motion().derivatives(stop.progress()); });
  py::list out;
  const auto& responses = motion.outcome().results.responses;
  const std::size_t n = motion.outcome().results.times.size();
  for (std::size_t r = 0; r < all.size(); ++r)
    out.append(owned(std::move(all[r]), {n, static_cast<std::size_t>(responses[r].components),
                                         motion.problem().parameters.size()}));
  return out;
}

py::array pull_back_of(const std::shared_ptr<MotionResult>& result, const py::list& given) {
  const Eigen::VectorXd g = run_job([result, weights = weights_of(given)](const Stop& stop) {
    return result->motion().pull_back(weights, stop.progress());
  });
  return owned({g.data(), g.data() + g.size()}, {static_cast<std::size_t>(g.size())});
}

std::vector<std::string> parameters_of(const MotionResult& result) {
  std::vector<std::string> names;
  for (const auto& p : result.motion().problem().names) names.push_back(p.name);
  return names;
}

std::vector<std::string> responses_of(const MotionResult& result) {
  std::vector<std::string> names;
  for (const auto& r : result.motion().problem().scene.responses) names.push_back(r.name);
  return names;
}

}  // namespace

void bind_outcomes(py::module_& module) {
  py::class_<Outcome, std::shared_ptr<Outcome>>(module, "Outcome")
      .def("names", &Outcome::names)
      .def("array", &array_of)
      .def("unit",
           [](const Outcome& o, const std::string& name) {
             const output::DataSet* set = o.find(name);
             return set ? set->unit : "";
           })
      .def("attributes",
           [](const Outcome& o, const std::string& group) {
             py::dict out;
             for (const auto& [key, text] : o.attributes(group)) out[py::str(key)] = text;
             return out;
           })
      .def("summary", &Outcome::summary)
      .def("save", &Outcome::save);
  py::class_<MotionResult, Outcome, std::shared_ptr<MotionResult>>(module, "Motion")
      .def("parameters", &parameters_of)
      .def("responses", &responses_of)
      .def("derivatives", &derivatives_of)
      .def("pull_back", &pull_back_of);
}

}  // namespace liesl::python
