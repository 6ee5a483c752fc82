#pragma once
// A straight bank of soft clay and the request to map it: small and coarse, done in seconds.

#include <filesystem>
#include <nlohmann/json.hpp>

namespace leda::tests {

/// Arc ASCII: 300 x 200 cells of 2 m from (380000, 5113000), rows of x. A plateau at 20 m in the
/// west, a bank of 12 m over 20 m from x = 380300 on, a plain at 8 m, a square hole without data
/// in the south-east.
void write_bank(const std::filesystem::path& file);

/// The same bank, of a height and a steepness that change from row to row, so that no two sections
/// are alike; without the hole.
void write_wavy_bank(const std::filesystem::path& file);

/// The query to register it with: the grid itself carries no CRS.
inline constexpr const char* bank_query = "?name=bank&epsg=2950&vertical_unit=m";

/// AA' and BB' across the bank and sections along its crest, cells of 2 m.
nlohmann::json bank_region();

}  // namespace leda::tests
