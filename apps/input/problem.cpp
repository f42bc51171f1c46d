#include "apps/input/problem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <tuple>

#include "apps/input/printable.hpp"

namespace liesl {

namespace {

std::string join(const std::vector<InputProblem>& problems) {
  std::string text;
  for (const InputProblem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += problem.text();
  }
  return text;
}

std::string lower(std::string_view text) {
  std::string low(text);
  for (char& c : low) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return low;
}

/// Keys, expressions and names of the user may have any length; messages may not.
std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 400, kHead = 200, kTail = 120;
  if (text.size() <= kLongest) return text;
  const auto inside = [&](std::size_t i) {  // a UTF-8 character
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
  };
  std::size_t head = kHead, tail = text.size() - kTail;
  while (inside(head)) --head;
  while (inside(tail)) ++tail;
  return fmt::format("{}... ({} characters) ...{}", text.substr(0, head), tail - head,
                     text.substr(tail));
}

}  // namespace

std::string InputProblem::text() const {
  std::string text = printable(file.starts_with("--set") ? shortened(file) : file);
  if (line > 0) text += fmt::format(":{}:{}", line, column);
  text += ": " + shortened(printable(what));
  if (!expected.empty()) text += "; expected " + shortened(printable(expected));
  if (!hint.empty()) text += "; hint: " + shortened(printable(hint));
  return text;
}

InputError::InputError(std::vector<InputProblem> list)
    : std::runtime_error(join(list)), problems(std::move(list)) {}

void Problems::add(const toml::node& at, std::string what, std::string expected, std::string hint) {
  add(at.source(), std::move(what), std::move(expected), std::move(hint));
}

void Problems::add(const toml::key& at, std::string what, std::string expected, std::string hint) {
  add(at.source(), std::move(what), std::move(expected), std::move(hint));
}

void Problems::add(const toml::source_region& at, std::string what, std::string expected,
                   std::string hint) {
  InputProblem problem{file_, 0, 0, std::move(what), std::move(expected), std::move(hint)};
  if (at.path) problem.file = *at.path;
  if (at.path && at.begin.line > 0) {
    problem.line = static_cast<int>(at.begin.line);
    problem.column = static_cast<int>(at.begin.column);
  }
  if (problem.file.starts_with("--set")) problem.line = problem.column = 0;
  problems_.push_back(std::move(problem));
}

bool Problems::has(const toml::node& at) const {
  const auto begin = at.source().begin;
  return std::any_of(problems_.begin(), problems_.end(), [&](const InputProblem& p) {
    return p.line == static_cast<int>(begin.line) && p.column == static_cast<int>(begin.column) &&
           written(at) && p.file == *at.source().path;
  });
}

namespace {

/// Leaves out what follows from a misspelt table: "the scene has no [bodies]" beside "did you mean
/// 'bodies'?".
void drop_consequences(std::vector<InputProblem>& problems) {
  constexpr std::string_view kMeant = "did you mean '";
  std::vector<std::string> said;
  for (const InputProblem& p : problems)
    if (p.what.starts_with("unknown key") && p.hint.starts_with(kMeant) && p.hint.ends_with("'?")) {
      const std::string name = p.hint.substr(kMeant.size(), p.hint.size() - kMeant.size() - 2);
      said.push_back("the scene has no " + name);
      said.push_back("the scene has no [" + name + "]");
    }
  std::erase_if(problems, [&](const InputProblem& p) {
    return std::ranges::count(said, p.what) + std::ranges::count(said, p.hint) > 0;
  });
}

}  // namespace

void Problems::throw_if_any() const {
  if (problems_.empty()) return;
  auto sorted = problems_;
  drop_consequences(sorted);
  const auto place = [](const InputProblem& p) { return std::tie(p.file, p.line, p.column); };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const InputProblem& a, const InputProblem& b) {
    return place(a) < place(b);
  });
  throw InputError(std::move(sorted));
}

int edit_distance(std::string_view first, std::string_view second) {
  const std::string a = lower(first), b = lower(second);
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

namespace {

/// "body" for "bodies", "joint" for "joints": the ending of a plural is one slip, not three.
std::string singular(std::string_view word) {
  if (word.ends_with("ies")) return std::string(word.substr(0, word.size() - 3)) + "y";
  return std::string(word.ends_with('s') ? word.substr(0, word.size() - 1) : word);
}

/// Slips between a word and the one that may be meant.
int slips(std::string_view word, std::string_view meant) {
  const std::string a = singular(word), b = singular(meant);
  return std::min(edit_distance(word, meant), a == b ? 1 : edit_distance(a, b) + 1);
}

}  // namespace

std::string nearest(std::string_view name, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongestName = 255;  // distances of longer ones cost time for nothing
  std::string best;
  if (name.size() > kLongestName) return best;
  int least = std::max<int>(1, static_cast<int>(name.size()) / 3) + 1;
  for (const std::string& candidate : candidates) {
    const int distance = slips(name, candidate);
    if (distance < least) std::tie(least, best) = std::make_tuple(distance, candidate);
  }
  return best;
}

std::string suggestion(std::string_view name, const std::vector<std::string>& candidates,
                       std::string_view otherwise) {
  if (const std::string best = nearest(name, candidates); !best.empty())
    return fmt::format("did you mean '{}'?", best);
  if (candidates.empty()) return std::string(otherwise);
  constexpr std::size_t kMany = 12;
  if (candidates.size() <= kMany) return fmt::format("known: {}", fmt::join(candidates, ", "));
  return fmt::format("known: {}, ...",
                     fmt::join(candidates.begin(), candidates.begin() + kMany, ", "));
}

}  // namespace liesl
