#pragma once
// Collects the faults of one document: pointer, value found, what would be right.

#include <string>
#include <string_view>
#include <vector>

#include "solver/section/validate.hpp"

namespace leda {

/// A number as a person writes it: 40.5, 1e+09, nan.
std::string show(double value);

/// A key as one part of a JSON pointer (RFC 6901): ~ and / escaped.
std::string pointer_part(std::string_view key);

class FaultList {
 public:
  void add(std::string pointer, std::string message);

  /// Each adds a fault and returns false where the value is not finite or not as its name says.
  /// `value` is in the unit of the case file.
  bool finite(const std::string& pointer, double value);
  bool positive(const std::string& pointer, double value, const std::string& unit);
  /// @param range how the range is written for a reader, for example "at least 0 and below 1"
  bool within(const std::string& pointer, double value, bool inside, const std::string& range);

  bool none() const { return faults_.empty(); }
  std::vector<Fault> take() { return std::move(faults_); }

 private:
  std::vector<Fault> faults_;
};

}  // namespace leda
