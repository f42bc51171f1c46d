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

/// Whoever asks wants to stop and has been heard: from now on what is left has to be done. Without
/// such a wish nothing changes.
void stop_is_heard();

/// While it lives nothing is stopped: of what has a result that would be lost.
class Unstopped {
 public:
  Unstopped();
  ~Unstopped();
  Unstopped(const Unstopped&) = delete;
  Unstopped& operator=(const Unstopped&) = delete;

 private:
  bool (*const before_)();
};

/// Cheap. @throws Stopped if whoever is asked wants to stop
void look_for_stop();

}  // namespace liesl
