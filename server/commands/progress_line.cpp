#include "server/commands/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace leda::server {

ProgressLine::ProgressLine(bool silent, std::chrono::milliseconds between)
    : silent_(silent),
      terminal_(isatty(STDERR_FILENO) != 0),
      between_(between),
      next_(std::chrono::steady_clock::now() + between) {}

void ProgressLine::show(const std::string& text) {
  if (silent_ || text == shown_) return;
  if (terminal_) {
    fmt::print(stderr, "\r\033[K{}", text);
  } else {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + between_;
    fmt::print(stderr, "{}\n", text);
  }
  shown_ = text;
}

void ProgressLine::end() {
  if (terminal_ && !shown_.empty()) fmt::print(stderr, "\n");
  shown_.clear();
}

void ProgressLine::end_with(const std::string& text) {
  if (!silent_ && !terminal_ && text != shown_) fmt::print(stderr, "{}\n", text);
  end();
}

}  // namespace leda::server
