#include "apps/cli/io_message.hpp"
#include "apps/input/problem.hpp"
#include "apps/output/interrupt.hpp"
#include "python/module/outcome.hpp"

namespace liesl::python {
namespace {

void raise(const char* type, const py::tuple& arguments) {
  const py::object error = py::module_::import("liesl.errors").attr(type);
  PyErr_SetObject(error.ptr(), error(*arguments).ptr());
}

/// Names of files may be of bytes that are no UTF-8: as Python's os.fsdecode has them.
py::object decoded(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape"));
}

struct Option {
  std::string_view flag, argument;
};

/// What is an option of the command line is an argument here.
constexpr Option kArguments[] = {
    {"--set ", "change "}, {"--by ", "by "}, {"--force replaces it", "overwrite=True replaces it"}};

std::string with_arguments(std::string text) {
  for (const auto& [flag, argument] : kArguments)
    if (const auto at = text.find(flag); at != std::string::npos)
      text.replace(at, flag.size(), argument);
  return text;
}

void raise_input(const std::vector<InputProblem>& problems) {
  const py::object make = py::module_::import("liesl.errors").attr("Problem");
  py::list list;
  for (const InputProblem& p : problems)
    list.append(
        make(with_arguments(p.what), p.expected, p.hint, with_arguments(p.file), p.line, p.column));
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
      raise("IoError",
            py::make_tuple(decoded(with_arguments(message(e))), decoded(e.path().string())));
    } catch (const std::filesystem::filesystem_error& e) {
      raise("IoError", py::make_tuple(decoded(e.what()), decoded(e.path1().string())));
    } catch (const output::Interrupted&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
}

}  // namespace liesl::python
