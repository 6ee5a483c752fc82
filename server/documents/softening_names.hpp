#pragma once
// The one table from a softening law's name in a document to its parameters, both ways.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "server/documents/object_reader.hpp"
#include "solver/section/material.hpp"

namespace leda::server {

struct SofteningName {
  const char* name;
  SofteningLaw (*read)(ObjectReader&);
};

/// Null where no law has the name.
const SofteningName* softening_named(std::string_view name);

/// "urmi, einav-randolph, ..."
std::string softening_names();

std::optional<Regularization> regularization_named(std::string_view name);

nlohmann::json to_document(const Softening& softening);

/// The kPa (or kN/m3) whose product with 1000 is `si` again, to the last bit, with the fewest
/// digits; the nearest where there is none.
double per_kilo(double si);

}  // namespace leda::server
