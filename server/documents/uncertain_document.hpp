#pragma once
// A document some of whose numbers are drawn: where paths lead, and the document of a member.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/documents/ensemble_reader.hpp"

namespace leda::server {

class UncertainDocument {
 public:
  /// Looks every path up. Faults stand at `at`/inputs/N/path: a path that names nothing, "*" that
  /// matches nothing, what is no number, a number that two inputs set.
  /// @param document without its "ensemble"
  /// @param places one an input
  UncertainDocument(nlohmann::json document, const std::vector<InputPlace>& places,
                    const std::string& at, FaultList& faults);

  /// As it was given.
  const nlohmann::json& given() const { return document_; }
  /// With the values of the inputs in their places: first what is set, then what is scaled and
  /// added to, in the order of the inputs.
  nlohmann::json with(const std::vector<double>& values) const;
  /// The input whose place, or a part of it, a pointer names; nothing: none.
  std::optional<std::size_t> input_at(const std::string& pointer) const;

 private:
  struct Target {
    nlohmann::json::json_pointer pointer;
    std::size_t input = 0;
    Apply apply = Apply::set;
  };

  void look_up(const InputPlace& place, std::size_t input, const std::string& at,
               FaultList& faults);
  void add_target(const nlohmann::json& value, const std::string& pointer, const InputPlace& place,
                  std::size_t input, const std::string& at, FaultList& faults);

  nlohmann::json document_;
  std::vector<Target> targets_;  ///< those that set first
};

}  // namespace leda::server
