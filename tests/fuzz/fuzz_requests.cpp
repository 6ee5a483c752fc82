// Any bytes as the body of POST /processes/{id}/execution: never a crash, and faults with pointers
// into the body.

#include <cstdint>
#include <string>

#include "server/documents/case_file.hpp"
#include "server/documents/execute_options.hpp"
#include "server/documents/hindcast_file.hpp"
#include "server/documents/region_request.hpp"
#include "server/documents/simulate_request.hpp"
#include "server/documents/study_file.hpp"
#include "tests/fuzz/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace leda;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto region = server::parse_region_request(text, server::DemNaming::registered_only);
  const auto section = server::parse_simulate_request(text);
  const auto study = server::parse_study_request(text);
  const auto hindcast = server::parse_hindcast_request(text);
  fuzz::require_faults_or_value(region);
  fuzz::require_faults_or_value(section);
  fuzz::require_faults_or_value(study);
  fuzz::require_faults_or_value(hindcast);
  if (region || section || study || hindcast) {
    const auto options = server::execute_options_of(text);
    fuzz::require(!options.raw || !options.outputs.empty(), "raw without an output");
  }
  if (region) fuzz::require(!region.value->soil.empty(), "a region without soil");
  return 0;
}
