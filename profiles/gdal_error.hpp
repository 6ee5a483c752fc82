#pragma once
// GDAL's errors: kept off the terminal, asked for where something failed.

#include <string>

namespace leda::profiles {

/// While it lives, GDAL prints nothing in this thread. The last message starts out empty.
class QuietGdal {
 public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

/// GDAL's last message in this thread, ": " before it; empty where there is none.
std::string gdal_message();

}  // namespace leda::profiles
