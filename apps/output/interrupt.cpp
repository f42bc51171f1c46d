#include "apps/output/interrupt.hpp"

#include <signal.h>

#include <atomic>

namespace liesl::output {
namespace {

std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free);

}  // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = [](int signal) { received.store(signal, std::memory_order_relaxed); };
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second one kills
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  ::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit of the shell is an error of write
}

int interrupted() { return received.load(std::memory_order_relaxed); }

void check_interrupt() {
  if (const int signal = interrupted()) throw Interrupted(signal);
}

}  // namespace liesl::output
