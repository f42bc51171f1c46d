#include "apps/output/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace liesl::output {
namespace {

/// 12.3 or 4.5k or 6.7M.
std::string short_number(double value) {
  if (value >= 1e6) return fmt::format("{:.1f}M", value / 1e6);
  if (value >= 1e4) return fmt::format("{:.0f}k", value / 1e3);
  return fmt::format("{:.{}f}", value, value < 10 ? 1 : 0);
}

std::string duration(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  if (s < 3600) return fmt::format("{}:{:02}", s / 60, s % 60);
  return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

Progress::Progress(std::string label, double total, std::string unit, bool quiet)
    : Progress(std::move(label), total, std::move(unit), quiet ? nullptr : stderr) {}

Progress::Progress(std::string label, double total, std::string unit, std::FILE* out)
    : label_(std::move(label)),
      unit_(std::move(unit)),
      total_(total),
      out_(out),
      live_(out != nullptr && ::isatty(::fileno(out)) == 1),
      start_(Clock::now()),
      next_(start_) {}

Progress::~Progress() { clear(); }

void Progress::update(double done, const std::string& note) {
  if (!live_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  const double seconds = std::chrono::duration<double>(now - start_).count();
  fmt::print(out_, "\r{}\033[K", line(done, seconds, note));
  std::fflush(out_);
  shown_ = true;
}

void Progress::say(const std::string& line) {
  if (!out_) return;
  clear();
  fmt::print(out_, "{}\n", line);
  std::fflush(out_);
}

std::string Progress::line(double done, double seconds, const std::string& note) const {
  const double share = total_ > 0 ? std::clamp(done / total_, 0.0, 1.0) : 0.0;
  std::string text = fmt::format("{} {:3.0f} %  {}/{} {}", label_, 100 * share, short_number(done),
                                 short_number(total_), unit_);
  if (seconds > 0.2 && done > 0) {
    text += fmt::format("  {}/s", short_number(done / seconds));
    if (share > 0) text += fmt::format("  {} left", duration(seconds * (1 / share - 1)));
  }
  return note.empty() ? text : text + "  " + note;
}

void Progress::clear() {
  if (!shown_) return;
  fmt::print(out_, "\r\033[K");
  std::fflush(out_);
  shown_ = false;
}

}  // namespace liesl::output
