// Any bytes as a case file: never a crash; faults that a reader can use; and what is taken means
// the same when it is written out and read again.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "server/documents/case_file.hpp"
#include "tests/fuzz/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace leda;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto parsed = server::parse_case_file(text);
  fuzz::require_faults_or_value(parsed);
  if (!parsed) return 0;
  const std::string written = server::canonical_text(*parsed.value);
  const auto again = server::parse_case_file(written);
  fuzz::require(bool(again), "what was taken is refused when it is written out");
  fuzz::require(server::canonical_text(*again.value) == written, "another case was read back");
  return 0;
}
