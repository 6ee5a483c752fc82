#pragma once
// What map-region is asked to do: the body of its execution, typed.

#include <string>
#include <string_view>
#include <vector>

#include "profiles/map/section_layout.hpp"
#include "profiles/map/soil_model.hpp"
#include "server/documents/ensemble_case.hpp"
#include "server/documents/parsed.hpp"
#include "solver/section/run_settings.hpp"

namespace leda::server {

/// What is under the ground of a region, and how its sections are run: what may be uncertain.
struct RegionGround {
  std::vector<SoilModel> soil;  ///< at least one
  RunSettings settings;         ///< trigger: always undrained
};

/// The ensemble of every section of a region. Its paths lead into `inputs` without the layout.
struct RegionEnsemble : Ensemble {
  /// What a member of a section draws. A number that an input of scope `soil` gives a soil model
  /// is drawn for that model, all others for `place`.
  Parsed<RegionGround> ground_of(const solver::Place& place, std::size_t member) const;
};

struct RegionRequest {
  std::string name;
  std::string dem;  ///< id or name of a registered raster; on the command line also a file
  SectionLayout layout;
  std::vector<SoilModel> soil;  ///< at least one
  RunSettings settings;         ///< trigger: always undrained
  bool skip_stable = true;      ///< sections that screening calls stable are not simulated
  std::optional<RegionEnsemble> ensemble;
};

struct RegionLimits {
  std::size_t most_sections = 20'000;
  std::size_t most_line_points = 10'000;  ///< of one line or polygon
};

/// Whether `dem` may be the path of a file: over HTTP never.
enum class DemNaming { registered_only, path_allowed };

/// Every fault at once; pointers start at /inputs.
Parsed<RegionRequest> parse_region_request(std::string_view text, DemNaming naming,
                                           const RegionLimits& limits = {});

}  // namespace leda::server
