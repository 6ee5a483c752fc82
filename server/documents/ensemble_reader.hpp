#pragma once
// "ensemble": which numbers of a document are uncertain, and how its members are drawn and ended.
// Format: README.md of this folder, "The ensemble"; published schema: "ensemble" in
// schema/definitions.json.

#include <optional>
#include <string>
#include <vector>

#include "server/documents/object_reader.hpp"
#include "solver/ensemble/summary.hpp"

namespace leda::server {

inline constexpr std::size_t most_members = 4096;
inline constexpr std::size_t most_uncertain_inputs = 50;

enum class Apply { set, scale, add };

const char* to_string(Apply apply);  ///< "set", "scale", "add"

/// Where an input goes.
struct InputPlace {
  std::string path;  ///< JSON pointer into the document; "*" stands for every member
  Apply apply = Apply::set;
};

struct EnsembleRequest {
  solver::EnsemblePlan plan;
  std::vector<InputPlace> places;  ///< one an input of the plan
  std::optional<double> raster_cell_m;
};

/// Every fault at once; paths are not looked up (uncertain_document.hpp).
EnsembleRequest read_ensemble(const nlohmann::json& value, const std::string& at,
                              FaultList& faults);

}  // namespace leda::server
