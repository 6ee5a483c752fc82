#include "server/documents/object_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace leda::server {
namespace {

using nlohmann::json;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool is_within(const std::string& inner, const std::string& outer) {
  return inner.starts_with(outer) && (inner.size() == outer.size() || inner[outer.size()] == '/');
}

std::string item(const std::string& at, std::size_t i) { return fmt::format("{}/{}", at, i); }

}  // namespace

std::string kind_of(const json& value) {
  switch (value.type()) {
    case json::value_t::null:
      return "null";
    case json::value_t::object:
      return "an object";
    case json::value_t::array:
      return "a list";
    case json::value_t::string:
      return "a text";
    case json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    default:
      return "the number " + show(value.get<double>());
  }
}

double read_number(const json& value, const std::string& at, FaultList& faults) {
  if (!value.is_number()) {
    faults.add(at, "is " + kind_of(value) + ", must be a number");
    return not_a_number;
  }
  const double number = value.get<double>();
  if (std::abs(number) <= largest_number) return number;
  faults.add(at, fmt::format("is {}, must be between -{} and {}", show(number),
                             show(largest_number), show(largest_number)));
  return not_a_number;
}

std::optional<std::array<double, 2>> read_pair(const json& value, const std::string& at,
                                               std::string_view what, FaultList& faults) {
  if (!value.is_array() || value.size() != 2) {
    faults.add(at, fmt::format("is {}, must be {}",
                               value.is_array() ? fmt::format("a list of {}", value.size())
                                                : kind_of(value),
                               what));
    return std::nullopt;
  }
  const double a = read_number(value[0], item(at, 0), faults);
  const double b = read_number(value[1], item(at, 1), faults);
  return std::array{a, b};
}

Polyline read_polyline(const json& value, const std::string& at, FaultList& faults) {
  Polyline line;
  if (!value.is_array() || value.empty()) {
    faults.add(at, fmt::format("is {}, must be a list of at least 2 points [x, z] in m",
                               value.is_array() ? "an empty list" : kind_of(value)));
    return line;
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    const auto pair = read_pair(value[i], item(at, i), "a point [x, z] in m", faults);
    // A point at fault keeps its place, so that the pointers of later ones stay right.
    line.push_back(pair ? Point{(*pair)[0], (*pair)[1]} : Point{not_a_number, not_a_number});
  }
  return line;
}

std::string read_text(const json& value, const std::string& at, std::size_t most,
                      FaultList& faults) {
  if (!value.is_string()) {
    faults.add(at, "is " + kind_of(value) + ", must be a text");
    return {};
  }
  const auto& text = value.get_ref<const std::string&>();
  if (text.empty() || text.size() > most) {
    faults.add(at, fmt::format("has {} bytes, must have 1 to {}", text.size(), most));
    return {};
  }
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::ranges::any_of(text, is_control)) {
    faults.add(at, "must not hold control characters such as line feeds");
    return {};
  }
  return text;
}

ObjectReader::ObjectReader(const json& value, std::string at, FaultList& faults)
    : value_(&value), at_(std::move(at)), faults_(faults), is_object_(value.is_object()) {
  if (!is_object_) faults_.add(at_, "is " + kind_of(value) + ", must be an object");
}

std::string ObjectReader::at(std::string_view key) const { return at_ + "/" + pointer_part(key); }

const json* ObjectReader::find(std::string_view key) {
  if (!is_object_) return nullptr;
  if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
  const auto member = value_->find(std::string(key));
  return member == value_->end() ? nullptr : &*member;
}

const json* ObjectReader::require(std::string_view key) {
  const json* member = find(key);
  if (!member && is_object_) faults_.add(at(key), "is missing");
  return member;
}

double ObjectReader::number(std::string_view key) {
  const json* member = require(key);
  return member ? read_number(*member, at(key), faults_) : not_a_number;
}

double ObjectReader::number_or(std::string_view key, double other) {
  return optional_number(key).value_or(other);
}

std::optional<double> ObjectReader::optional_number(std::string_view key) {
  const json* member = find(key);
  if (!member) return std::nullopt;
  return read_number(*member, at(key), faults_);
}

std::int64_t ObjectReader::integer_or(std::string_view key, std::int64_t other) {
  constexpr std::int64_t largest = std::int64_t{1} << 53;  // beyond, other JSON readers round
  const json* member = find(key);
  if (!member) return other;
  if (member->is_number_integer() && *member >= 0 && *member <= largest) {
    return member->get<std::int64_t>();
  }
  faults_.add(at(key),
              fmt::format("is {}, must be a whole number from 0 to {}", kind_of(*member), largest));
  return other;
}

bool ObjectReader::boolean_or(std::string_view key, bool other) {
  const json* member = find(key);
  if (!member) return other;
  if (member->is_boolean()) return member->get<bool>();
  faults_.add(at(key), "is " + kind_of(*member) + ", must be true or false");
  return other;
}

std::string ObjectReader::text(std::string_view key, std::size_t most) {
  const json* member = require(key);
  return member ? read_text(*member, at(key), most, faults_) : std::string{};
}

std::string ObjectReader::text_or_empty(std::string_view key, std::size_t most) {
  const json* member = require(key);
  if (!member || (member->is_string() && member->get_ref<const std::string&>().empty())) return {};
  return read_text(*member, at(key), most, faults_);
}

std::optional<Point> ObjectReader::optional_point(std::string_view key) {
  const json* member = find(key);
  if (!member) return std::nullopt;
  const auto pair = read_pair(*member, at(key), "a point [x, z] in m", faults_);
  return pair ? Point{(*pair)[0], (*pair)[1]} : Point{not_a_number, not_a_number};
}

void ObjectReader::refuse_unknown() {
  if (!is_object_) return;
  for (const auto& member : value_->items()) {
    if (std::ranges::find(known_, member.key()) != known_.end()) continue;
    faults_.add(at(member.key()),
                fmt::format("is not known here; known are: {}", fmt::join(known_, ", ")));
  }
}

int read_count(ObjectReader& reader, const char* key, int absent, int most, FaultList& faults) {
  const std::int64_t count = reader.integer_or(key, absent);
  if (count <= most) return int(count);
  faults.add(reader.at(key), fmt::format("is {}, must be at most {}", count, most));
  return absent;
}

void add_new_faults(std::vector<Fault>& faults, std::vector<Fault> more) {
  const std::size_t already = faults.size();
  for (Fault& fault : more) {
    const auto about_the_same = [&](const Fault& known) {
      return is_within(fault.pointer, known.pointer) || is_within(known.pointer, fault.pointer);
    };
    const auto end = faults.begin() + std::ptrdiff_t(already);
    if (std::none_of(faults.begin(), end, about_the_same)) faults.push_back(std::move(fault));
  }
}

}  // namespace leda::server
