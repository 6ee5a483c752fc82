// Any bytes as a DEM: taken whole or refused with a DemError, and nothing is left behind. The first
// byte says what the client states beside the file.

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "profiles/register_dem.hpp"
#include "tests/fuzz/require.hpp"

namespace {

namespace fs = std::filesystem;
using namespace leda;

const fs::path& folder() {
  static const fs::path made = [] {
    const fs::path memory = fs::is_directory("/dev/shm") ? "/dev/shm" : fs::temp_directory_path();
    fs::path unique = memory / ("leda-fuzz-" + std::to_string(getpid()));
    fs::create_directories(unique);
    return unique;
  }();
  return made;
}

profiles::DemOptions stated(std::uint8_t choice) {
  profiles::DemOptions options;
  if ((choice & 1) != 0) options.epsg = 2950;
  if ((choice & 2) != 0) options.vertical_unit = (choice & 4) != 0 ? "ft" : "m";
  options.limits.most_bytes = 1 << 22;
  return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const fs::path input = folder() / "input", output = folder() / "output.tif";
  std::ofstream(input, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  bool taken = false;
  try {
    const auto dem = profiles::register_dem(input, output, stated(data[0]));
    taken = true;
    fuzz::require(dem.info.width > 0 && dem.info.height > 0 && dem.info.epsg > 0, "no grid");
    fuzz::require(std::isfinite(dem.lowest_m) && dem.lowest_m <= dem.highest_m, "no elevations");
    fuzz::require(profiles::Dem::open(output).info().width == dem.info.width, "another grid");
  } catch (const profiles::DemError& error) {
    fuzz::require(error.what()[0] != '\0', "a refusal without a reason");
  }
  fuzz::require(fs::exists(output) == taken, "the file and the answer say different things");
  fs::remove(output);
  fs::remove(input);
  fuzz::require(fs::is_empty(folder()), "something was left behind");
  return 0;
}
