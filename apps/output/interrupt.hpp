#pragma once
/// @file
/// Ctrl-C as a request: the run ends at the next good place, with its last complete state.

#include <stdexcept>

namespace liesl::output {

/// Thrown at a good place to stop. Signal number in `signal`.
struct Interrupted : std::runtime_error {
  explicit Interrupted(int number) : std::runtime_error("interrupted"), signal(number) {}
  int signal;
};

/// From now on SIGINT, SIGTERM and SIGHUP set a flag; a second one ends the program at once.
void catch_interrupts();

/// Signal that has come, 0 if none has. Cheap: one relaxed load.
int interrupted();

/// @throws Interrupted if a signal has come
void check_interrupt();

}  // namespace liesl::output
