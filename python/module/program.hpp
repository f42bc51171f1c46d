#pragma once
/// @file
/// Studies as nonlinear programs, `_liesl.Program`.

#include <pybind11/pybind11.h>

#include <memory>

#include "apps/study/study.hpp"

namespace liesl::python {

/// @throws as study_nlp (apps/tasks/study_nlp.hpp)
pybind11::object program_of(const std::shared_ptr<const Study>& study);

}  // namespace liesl::python
