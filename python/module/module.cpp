/// @file
/// The compiled part of the Python package liesl. Its functions take what the package has checked;
/// scripts use the package.

#include "apps/output/versions.hpp"
#include "python/module/job.hpp"
#include "python/module/outcome.hpp"

PYBIND11_MODULE(_liesl, module) {
  using namespace liesl::python;
  module.doc() = "Compiled part of the package liesl.";
  module.attr("__version__") = liesl::output::versions().front().second;
  py::module_::import("atexit").attr("register")(py::cpp_function(&join_left));
  bind_errors(module);
  bind_outcomes(module);
  bind_folders(module);
  bind_scenes(module);
#ifdef LIESL_OPTIM
  bind_studies(module);
  bind_programs(module);
  bind_minimize(module);
#endif
}
