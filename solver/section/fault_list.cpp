#include "solver/section/fault_list.hpp"

#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

namespace leda {

std::string show(double value) {
  char text[32];
  const auto end =
      std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, 10);
  return {std::begin(text), end.ptr};
}

std::string pointer_part(std::string_view key) {
  std::string part;
  for (const char c : key) {
    if (c == '~') {
      part += "~0";
    } else if (c == '/') {
      part += "~1";
    } else {
      part += c;
    }
  }
  return part;
}

void FaultList::add(std::string pointer, std::string message) {
  faults_.push_back({std::move(pointer), std::move(message)});
}

bool FaultList::finite(const std::string& pointer, double value) {
  return within(pointer, value, true, "a finite number");
}

bool FaultList::positive(const std::string& pointer, double value, const std::string& unit) {
  return within(pointer, value, value > 0, "greater than 0" + (unit.empty() ? "" : " " + unit));
}

bool FaultList::within(const std::string& pointer, double value, bool inside,
                       const std::string& range) {
  if (std::isfinite(value) && inside) return true;
  add(pointer, "is " + show(value) + ", must be " + range);
  return false;
}

}  // namespace leda
