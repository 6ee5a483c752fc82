#pragma once
// The kinds of job by their names, which stand in requests, in the store and in answers.

namespace leda::server {

inline constexpr const char* map_region_id = "map-region";
inline constexpr const char* simulate_section_id = "simulate-section";
inline constexpr const char* resolution_study_id = "resolution-study";
inline constexpr const char* hindcast_id = "hindcast";

}  // namespace leda::server
