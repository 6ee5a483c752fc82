#pragma once
// The rules of the house, each over a whole source tree.

#include <ostream>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.hpp"

namespace leda::architecture {

struct Breach {
  std::string file;
  int line = 0;  ///< 0: the file as a whole
  std::string what;
};

std::ostream& operator<<(std::ostream& out, const Breach& breach);

/// Arrows go one way: solver and disk know nothing of Leda, profiles and db stand on porches and
/// disk only, server and tests may include all. Includes are written from the root of the
/// repository.
std::vector<Breach> wrong_directions(const SourceTree& tree);

/// The rooms inside solver/ and server/ have arrows of their own, and no folder there is another.
std::vector<Breach> wrong_directions_inside(const SourceTree& tree);

/// No header leads back to itself.
std::vector<Breach> circles(const SourceTree& tree);

/// A porch header stands on the standard library and on porches alone.
std::vector<Breach> porches_with_walls(const SourceTree& tree);

/// GDAL, SQLite, HDF5 and HTTP stay in their rooms: no file of another room sees their headers,
/// not even through a header of ours.
std::vector<Breach> open_fences(const SourceTree& tree);

/// What knows the inner parts of cpp-httplib stands in one file: with another release of it the
/// build breaks there and nowhere else.
std::vector<Breach> inner_parts_of_httplib(const SourceTree& tree);

/// No file or folder is a drawer for whatever has no place.
std::vector<Breach> drawers(const SourceTree& tree);

/// At the top stand the build's files, the licence and documents: no log or record of a run.
std::vector<Breach> strays_at_the_top(const SourceTree& tree);

/// No text names a folder of the machine it was written on.
std::vector<Breach> machine_paths(const SourceTree& tree);

/// TypeScript and JavaScript have no formatter here: no line of theirs is longer than 130
/// characters, but in the file of words, where a text stands on one line.
std::vector<Breach> long_lines(const SourceTree& tree);

std::vector<Breach> all_breaches(const SourceTree& tree);

}  // namespace leda::architecture
