#include "apps/batch/worker.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "apps/output/io_error.hpp"

namespace liesl {

namespace {

sigset_t child_signal() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGCHLD);
  return set;
}

/// In the new process, up to its program. Its own group: Ctrl-C comes from the pool only.
[[noreturn]] void become(char* const* command, int log, const Worker::Limits& limits,
                         pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // it died before the line above
  const sigset_t set = child_signal();
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
  if (limits.memory) {
    const auto bytes = static_cast<rlim_t>(*limits.memory * 1e6);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::execv(command[0], command);
  ::_exit(127);
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

Worker::Worker(const std::vector<std::string>& command, int log, const Limits& limits)
    : limits_(limits) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) throw output::IoError("run", command[0], std::strerror(errno));
  if (pid_ == 0) become(arguments.data(), log, limits, parent);
}

std::optional<WorkerEnd> Worker::poll() {
  const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
  int status = 0;
  rusage usage{};
  pid_t ended = 0;
  do ended = ::wait4(pid_, &status, WNOHANG, &usage);
  while (ended < 0 && errno == EINTR);
  if (ended == 0) {
    if (!stopped_ && limits_.time && wall > *limits_.time) stopped_ = ::kill(pid_, SIGKILL) == 0;
    return {};
  }
  WorkerEnd end;
  end.wall_s = wall;
  end.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.peak_memory_mb = static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts in kB
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  end.out_of_time = stopped_ && end.signal == SIGKILL;
  return end;
}

void Worker::interrupt() const { ::kill(pid_, SIGINT); }

ChildSignal::ChildSignal() {
  const sigset_t set = child_signal();
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
}

ChildSignal::~ChildSignal() {
  const sigset_t set = child_signal();
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

void ChildSignal::wait(double seconds) const {
  const sigset_t set = child_signal();
  const timespec most{
      static_cast<time_t>(seconds),
      static_cast<long>(1e9 * (seconds - static_cast<double>(static_cast<time_t>(seconds))))};
  ::sigtimedwait(&set, nullptr, &most);
}

}  // namespace liesl
