#pragma once
// The body of simulate-section: {"inputs": {"case": {...}, "ensemble": {...}}}.

#include <optional>
#include <string_view>

#include "server/documents/ensemble_case.hpp"

namespace leda::server {

struct SimulateRequest {
  CaseFile of;
  std::optional<EnsembleCase> ensemble;  ///< of the case; its paths lead into the case
};

/// Every fault at once; pointers start at /inputs/case and /inputs/ensemble.
Parsed<SimulateRequest> parse_simulate_request(std::string_view text,
                                               Members members = Members::checked);

}  // namespace leda::server
