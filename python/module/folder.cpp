#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "apps/output/file.hpp"
#include "apps/output/hdf5_input.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"
#include "apps/output/result_summary.hpp"
#include "apps/report/report.hpp"
#include "python/module/outcome.hpp"

namespace liesl::python {
namespace {

using output::Hdf5Input;
using output::Hdf5Kind;

/// The data sets of one HDF5 file.
class Hdf5Sets {
 public:
  explicit Hdf5Sets(const std::filesystem::path& path) : file_(path) { add("", names_); }
  const std::vector<std::string>& names() const { return names_; }
  std::string unit(const std::string& name) const { return file_.attribute("/" + name, "unit"); }
  std::string attribute(const std::string& group, const std::string& key) const {
    return file_.attribute("/" + group, key);
  }

  py::object array(const std::string& name) const {
    const std::string path = "/" + name;
    if (!file_.has(path)) return py::none();
    const Hdf5Kind kind = file_.kind(path);
    if (kind == Hdf5Kind::Group) return py::none();
    if (kind == Hdf5Kind::Texts) return py::cast(file_.texts(path));
    output::Hdf5Numbers numbers = file_.numbers(path);
    py::array array = owned(std::move(numbers.values), numbers.shape);
    if (kind == Hdf5Kind::Numbers) return array;
    array = array.attr("astype")("int32");
    array.attr("setflags")(py::arg("write") = false);
    return array;
  }

 private:
  void add(const std::string& group, std::vector<std::string>& names) const {
    for (const std::string& child : file_.children(group.empty() ? "/" : "/" + group)) {
      const std::string name = group.empty() ? child : group + "/" + child;
      if (file_.kind("/" + name) == Hdf5Kind::Group)
        add(name, names);
      else
        names.push_back(name);
    }
  }

  Hdf5Input file_;
  std::vector<std::string> names_;
};

void require_result(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw output::IoError("open", folder, "there is no such folder");
  if (!output::is_result(folder))
    throw output::IoError("open", folder, "it holds no result of liesl");
}

}  // namespace

void bind_folders(py::module_& module) {
  py::class_<Hdf5Sets>(module, "Hdf5Sets")
      .def(py::init<const std::filesystem::path&>())
      .def("names", &Hdf5Sets::names)
      .def("array", &Hdf5Sets::array)
      .def("unit", &Hdf5Sets::unit)
      .def("attribute", &Hdf5Sets::attribute);
  module.def("require_result", &require_result);
  module.def("check_hdf5_files", [](const std::filesystem::path& folder) {
    const auto text = output::read_file(folder / "summary.json");
    output::check_hdf5_files(folder, nlohmann::ordered_json::parse(text), "open");
  });
  module.def("read_file",
             [](const std::filesystem::path& path) { return output::read_file(path); });
  module.def("write_file", [](const std::filesystem::path& path, const std::string& text) {
    output::replace_file(path, text);
  });
  module.def("page_of", &report::page_of_whole);
}

}  // namespace liesl::python
