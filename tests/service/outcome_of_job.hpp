#pragma once
// Everything a job left, without what depends on the clock: to compare two data folders.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/service/leda_process.hpp"

namespace leda::tests {

struct JobOutcome {
  nlohmann::json zones;  ///< geometry of release, runout and probability zones
  std::string members;   ///< members.csv without run times; empty: no ensemble
  std::map<std::string, nlohmann::json> results;         ///< result.json by section
  std::map<std::string, std::string> profiles;           ///< profile_after.csv by section
  std::map<std::string, std::filesystem::path> folders;  ///< of the run whose result stands
};

/// @param data the server's data folder
JobOutcome outcome_of(LedaServer& server, const std::filesystem::path& data,
                      const std::string& job);

/// Every difference in words; the particles of all frames are compared as well. Empty: none.
std::vector<std::string> differences(const JobOutcome& one, const JobOutcome& other);

/// What the store itself says: a job's sections without exactly one result, results of no section
/// of it, runs under way. Empty: each section of the only job has one result.
std::vector<std::string> faults_of_store(const std::filesystem::path& file);

}  // namespace leda::tests
