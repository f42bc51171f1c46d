/// @file
/// The end of a program without address space, by system calls alone: nothing else may work then.
#pragma once

#include <unistd.h>

#include <string_view>

namespace liesl {

/// Says so on the standard error and ends the process with exit code 3.
[[noreturn]] inline void end_out_of_memory() {
  constexpr std::string_view kMessage =
      "liesl: out of memory; use fewer elements, a larger step or output_every, or allow it more "
      "address space (the linear algebra alone takes 128 MB a thread)\n";
  constexpr int kFailed = 3;
  (void)!::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  ::_exit(kFailed);
}

}  // namespace liesl
