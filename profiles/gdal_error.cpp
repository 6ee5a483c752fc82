#include "profiles/gdal_error.hpp"

#include <cpl_error.h>

namespace leda::profiles {

QuietGdal::QuietGdal() {
  CPLErrorReset();
  CPLPushErrorHandler(CPLQuietErrorHandler);
}

QuietGdal::~QuietGdal() { CPLPopErrorHandler(); }

std::string gdal_message() {
  const std::string message = CPLGetLastErrorMsg();
  return message.empty() ? message : ": " + message;
}

}  // namespace leda::profiles
