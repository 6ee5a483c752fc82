#pragma once
// Reads the members of a JSON object one by one and says what is wrong with each: missing, of the
// wrong type, unknown. A value at fault is read as NaN or empty, so that reading can go on.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/section/fault_list.hpp"
#include "solver/section/geometry.hpp"

namespace leda::server {

/// Numbers beyond this are refused: nothing about a slope is that large.
inline constexpr double largest_number = 1e12;

/// "a number", "an object", ...: what a value is, for a message.
std::string kind_of(const nlohmann::json& value);

/// A number within largest_number; else a fault and NaN.
double read_number(const nlohmann::json& value, const std::string& at, FaultList& faults);

/// Two numbers, "what" for the message, for example "[x, z] in m".
std::optional<std::array<double, 2>> read_pair(const nlohmann::json& value, const std::string& at,
                                               std::string_view what, FaultList& faults);

/// A list of [x, z]. Items at fault are left out. An empty list is a fault.
Polyline read_polyline(const nlohmann::json& value, const std::string& at, FaultList& faults);

/// Text of 1 to `most` bytes without control characters; else a fault and an empty text.
std::string read_text(const nlohmann::json& value, const std::string& at, std::size_t most,
                      FaultList& faults);

class ObjectReader {
 public:
  /// A value that is no object is a fault; every member then reads as absent, without more faults.
  ObjectReader(const nlohmann::json& value, std::string at, FaultList& faults);

  bool is_object() const { return is_object_; }
  std::string at(std::string_view key) const;

  /// The member, or nothing; optional members may be absent but not null.
  const nlohmann::json* find(std::string_view key);
  /// The member; a fault where it is absent.
  const nlohmann::json* require(std::string_view key);

  double number(std::string_view key);                   ///< required
  double number_or(std::string_view key, double other);  ///< `other` where absent
  std::optional<double> optional_number(std::string_view key);
  std::int64_t integer_or(std::string_view key, std::int64_t other);
  bool boolean_or(std::string_view key, bool other);
  std::string text(std::string_view key, std::size_t most = 200);     ///< required
  std::string text_or_empty(std::string_view key, std::size_t most);  ///< required, may be empty
  std::optional<Point> optional_point(std::string_view key);

  /// Every member that nobody asked for is a fault.
  void refuse_unknown();

 private:
  const nlohmann::json* value_;
  std::string at_;
  FaultList& faults_;
  bool is_object_;
  std::vector<std::string> known_;
};

/// A whole number from 0 to `most`; `absent` where it is absent or at fault.
int read_count(ObjectReader& reader, const char* key, int absent, int most, FaultList& faults);

/// Adds to `faults` those of `more` that are not about a value (or a part or a whole of one) that
/// is at fault already: a value that could not be read would only be found wrong again.
void add_new_faults(std::vector<Fault>& faults, std::vector<Fault> more);

}  // namespace leda::server
