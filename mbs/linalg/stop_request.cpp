#include "mbs/linalg/stop_request.hpp"

#include <atomic>

namespace liesl {
namespace {

std::atomic<bool (*)()> asked{nullptr};

}  // namespace

void ask_for_stop(bool (*wants_to_stop)()) { asked.store(wants_to_stop); }

void stop_is_heard() {
  if (const auto wants_to_stop = asked.load(); wants_to_stop && wants_to_stop())
    asked.store(nullptr);
}

Unstopped::Unstopped() : before_(asked.exchange(nullptr)) {}
Unstopped::~Unstopped() { asked.store(before_); }

void look_for_stop() {
  if (const auto wants_to_stop = asked.load(std::memory_order_relaxed);
      wants_to_stop && wants_to_stop())
    throw Stopped();
}

}  // namespace liesl
