#pragma once
// What the members of an ensemble or of a hindcast are warned of that their base case is not.

#include <cstddef>
#include <string>
#include <vector>

#include "server/documents/hindcast_document.hpp"
#include "server/documents/member_rows.hpp"
#include "solver/section/gathered_warnings.hpp"

namespace leda::server {

/// "17 of 64 members: TEXT", a line for each text that the base is not warned of. Where texts
/// differ in their numbers alone, the first stands for all: "17 of 64 members, such as: TEXT".
/// @param gathered of members, each by a name of its own
/// @param all how many members there are
std::vector<std::string> member_lines(const GatheredWarnings& gathered, std::size_t all,
                                      const std::vector<std::string>& base);

/// The same of the first members of a section: those that count in what the ensemble says, not
/// their other seeds and finer cells.
std::vector<std::string> member_lines(const std::vector<MemberRow>& rows, std::size_t members,
                                      const std::vector<std::string>& base);

/// What the cases of the past slides are warned of, then their members, with the slides it is
/// about: "Saint-Jude: 17 of 64 members: TEXT". @param rows empty before they are run
std::vector<std::string> hindcast_warnings(const HindcastFile& file,
                                           const std::vector<HindcastRow>& rows,
                                           std::size_t members);

}  // namespace leda::server
