#pragma once
// What an execute request says beside its inputs (OGC API - Processes 1.0, 7.11).

#include <string>
#include <vector>

#include "server/documents/object_reader.hpp"

namespace leda::server {

struct ExecuteOptions {
  bool dry_run = false;              ///< check, lay out and estimate; nothing is stored or run
  std::vector<std::string> outputs;  ///< wanted ones; empty: all
  bool raw = false;                  ///< the one wanted output alone, not in a document of outputs
};

/// Reads the members dryRun, outputs and response. `subscriber` is refused: nobody is called back.
ExecuteOptions read_execute_options(ObjectReader& body, FaultList& faults);

/// The options of a request that the reader of its process took.
ExecuteOptions execute_options_of(const std::string& request);

/// JSON schema of those members, as properties of the body.
nlohmann::json execute_options_schema();

}  // namespace leda::server
