#include "apps/input/problem.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/output/io_error.hpp"
#include "python/module/outcome.hpp"

namespace liesl::python {
namespace {

void raise(const char* type, const py::tuple& arguments) {
  const py::object error = py::module_::import("liesl.errors").attr(type);
  PyErr_SetObject(error.ptr(), error(*arguments).ptr());
}

/// Here a change by key path is an argument, not an option of the command line.
std::string place(const std::string& file) {
  constexpr std::string_view kOption = "--set ";
  return file.starts_with(kOption) ? "change " + file.substr(kOption.size()) : file;
}

void raise_input(const std::vector<InputProblem>& problems) {
  const py::object make = py::module_::import("liesl.errors").attr("Problem");
  py::list list;
  for (const InputProblem& p : problems)
    list.append(make(p.what, p.expected, p.hint, place(p.file), p.line, p.column));
  raise("InputError", py::make_tuple(list));
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const InputError& e) {
      raise_input(e.problems);
    } catch (const std::invalid_argument& e) {
      raise_input({{"", 0, 0, e.what(), "", ""}});
    } catch (const output::IoError& e) {
      raise("IoError", py::make_tuple(e.what(), e.path().string()));
    } catch (const std::filesystem::filesystem_error& e) {
      raise("IoError", py::make_tuple(e.what(), e.path1().string()));
    } catch (const output::Interrupted&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
}

}  // namespace liesl::python
