#pragma once
// Texts for the table of a Shapefile (DBF), which holds 254 bytes a field: they end at a whole item
// and say that they do.

#include <string>
#include <vector>

namespace leda::profiles {

inline constexpr std::size_t most_dbf_bytes = 254;

/// Items with something between them; of more than `most` bytes the first ones, and how many more
/// there are.
std::string joined_within(const std::vector<std::string>& items, const std::string& between,
                          std::size_t most);

/// A text of at most `most` bytes, ended by "..." where it was longer; never within a letter.
std::string ended_within(const std::string& text, std::size_t most);

}  // namespace leda::profiles
