#pragma once
/// @file
/// What a task leaves behind, as Python sees it: data sets by name, a summary, files.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/output/data_tree.hpp"
#include "apps/tasks/differentiable_motion.hpp"

namespace liesl::python {

namespace py = pybind11;

/// The results of a task, which stay as they are: arrays of their numbers are views.
class Outcome {
 public:
  virtual ~Outcome() = default;
  Outcome(const Outcome&) = delete;
  Outcome& operator=(const Outcome&) = delete;

  virtual std::string summary() const = 0;  ///< summary.json
  /// Its files, but the page, into a folder that is there.
  virtual void write(const std::filesystem::path& folder) const = 0;

  /// Names as in results.h5, without the slash in front.
  std::vector<std::string> names() const;
  const output::DataSet* find(const std::string& name) const;
  /// Attributes of a group; empty for "": of the whole.
  std::vector<std::pair<std::string, std::string>> attributes(const std::string& group) const;
  /// Results folder, by default with report.html.
  void save(const std::filesystem::path& target, bool overwrite, bool page) const;

 protected:
  Outcome() = default;
  /// @param results outlive this
  void show(const output::Results& results) { tree_ = output::data_tree(results); }

 private:
  output::DataTree tree_;
};

class RunResult final : public Outcome {
 public:
  explicit RunResult(RunOutcome outcome) : outcome_(std::move(outcome)) { show(outcome_.results); }
  std::string summary() const override;
  void write(const std::filesystem::path& folder) const override;

 private:
  RunOutcome outcome_;
};

/// A motion that can be differentiated.
class MotionResult final : public Outcome {
 public:
  explicit MotionResult(std::unique_ptr<DifferentiableMotion> motion) : motion_(std::move(motion)) {
    show(motion_->outcome().results);
  }
  const DifferentiableMotion& motion() const { return *motion_; }
  std::string summary() const override;
  void write(const std::filesystem::path& folder) const override;

 private:
  std::unique_ptr<DifferentiableMotion> motion_;
};

/// An array that shares the memory of `owner` and cannot be written to.
py::array view(const double* data, const std::vector<std::size_t>& shape, const py::object& owner);
/// An array that has numbers of its own, and cannot be written to.
py::array owned(std::vector<double> numbers, const std::vector<std::size_t>& shape);

void bind_outcomes(py::module_& module);
void bind_folders(py::module_& module);
void bind_scenes(py::module_& module);
void bind_errors(py::module_& module);
#ifdef LIESL_OPTIM
void bind_studies(py::module_& module);
void bind_programs(py::module_& module);
void bind_minimize(py::module_& module);
#endif

}  // namespace liesl::python
