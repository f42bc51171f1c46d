#pragma once
/// @file
/// Work without the interpreter's lock, and Ctrl-C while it goes on.

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <future>
#include <memory>
#include <thread>

#include "apps/output/interrupt.hpp"

namespace liesl::python {

namespace py = pybind11;

/// A request to stop. A job that is started by another one also stops with that.
class Stop {
 public:
  Stop() : parent_(of_this_thread()) {}
  void request() { *requested_ = true; }
  bool requested() const { return *requested_ || (parent_ && *parent_); }
  /// For simulations: ends them at once, by an exception. What they have so far is of no use.
  std::function<bool(double)> progress() const {
    return [this](double) {
      if (requested()) throw output::Interrupted(SIGINT);
      return true;
    };
  }

  /// While it lives, jobs that are started in this thread stop with `stop`.
  class Scope {
   public:
    explicit Scope(const Stop& stop) : before_(std::move(of_this_thread())) {
      of_this_thread() = stop.requested_;
    }
    ~Scope() { of_this_thread() = std::move(before_); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    std::shared_ptr<std::atomic<bool>> before_;
  };

 private:
  static std::shared_ptr<std::atomic<bool>>& of_this_thread() {
    thread_local std::shared_ptr<std::atomic<bool>> flag;
    return flag;
  }

  std::shared_ptr<std::atomic<bool>> parent_;
  std::shared_ptr<std::atomic<bool>> requested_ = std::make_shared<std::atomic<bool>>(false);
};

/// How often a waiting thread looks for signals, and how long it then waits for the work to end.
constexpr std::chrono::milliseconds kSignals{20}, kPatience{40};

/// A Python object that may die in any thread.
using Held = std::shared_ptr<const py::object>;
inline Held hold(py::object object) {
  return {new py::object(std::move(object)), [](const py::object* held) {
            const py::gil_scoped_acquire locked;
            delete held;
          }};
}

/// Threads whose work goes on to its next look at the stop after Ctrl-C has been raised.
void leave(std::thread thread);
/// Waits for them; at the end of the interpreter.
void join_left();

/// Runs `work(stop)` in a thread of its own, while this one waits without the interpreter's lock
/// and looks for signals: Python sees them in its main thread only, and work may be in threads of
/// TBB. A signal whose handler raises (Ctrl-C) requests the stop, and is raised once the work has
/// ended or after kPatience; then what the work still does is of no use to anybody.
/// @param work owns what it uses; Python objects are `Held`
/// @returns what the work returns  @throws what it throws
template <class Work>
auto run_job(Work work) {
  using Out = std::invoke_result_t<Work, const Stop&>;
  using Clock = std::chrono::steady_clock;
  const auto stop = std::make_shared<Stop>();
  const auto task = std::make_shared<std::packaged_task<Out()>>([stop, work = std::move(work)] {
    const Stop::Scope scope(*stop);
    return work(*stop);
  });
  std::future<Out> out = task->get_future();
  std::exception_ptr signal;
  {
    const py::gil_scoped_release unlocked;
    std::thread thread([task] { (*task)(); });
    Clock::time_point last = Clock::time_point::max();
    while (out.wait_for(kSignals) != std::future_status::ready && Clock::now() < last) {
      const py::gil_scoped_acquire locked;
      if (signal || PyErr_CheckSignals() == 0) continue;
      signal = std::make_exception_ptr(py::error_already_set());
      stop->request();
      last = Clock::now() + kPatience;
    }
    if (out.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
      thread.join();
    else
      leave(std::move(thread));
  }
  if (signal) std::rethrow_exception(signal);
  return out.get();
}

}  // namespace liesl::python
