#pragma once
// How far something long is, on standard error: on a terminal one line that changes, elsewhere a
// line now and then.

#include <chrono>
#include <string>

namespace leda::server {

class ProgressLine {
 public:
  /// @param silent shows nothing; JSON on standard output is no reason to be
  /// @param between lines where there is no terminal; the first comes after it
  explicit ProgressLine(bool silent = false,
                        std::chrono::milliseconds between = std::chrono::seconds(10));

  void show(const std::string& text);
  /// Goes on to the next line of a terminal, where one was begun.
  void end();
  /// The same; where there is no terminal tells how far it came, however short it was.
  void end_with(const std::string& text);

 private:
  bool silent_, terminal_;
  std::chrono::milliseconds between_;
  std::string shown_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace leda::server
