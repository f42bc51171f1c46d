#pragma once
/// @file
/// Long calculations on meshes look here, between pieces of their work, whether they are still
/// wanted: factors of matrices, blocks of load cases, iterations for modes.

#include <exception>

namespace liesl {

/// Thrown where a calculation is given up: it has no result.
struct Stopped final : std::exception {
  const char* what() const noexcept override { return "stopped on request"; }
};

/// Who is asked, for the whole process and from any of its threads; null: nobody any more, what is
/// left has to be done.
void ask_for_stop(bool (*wants_to_stop)());

/// Cheap. @throws Stopped if whoever is asked wants to stop
void look_for_stop();

}  // namespace liesl
