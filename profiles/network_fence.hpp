#pragma once
// No file system of GDAL but those of this machine. Private to profiles/.

namespace leda::profiles {

/// CPL_VSIL_CURL_ALLOWED_FILENAME binds /vsicurl/ alone: /vsicurl_streaming/ opens connections all
/// the same. So every virtual file system that GDAL does not need for files of this machine is
/// replaced by one in which nothing is.
void close_network();

}  // namespace leda::profiles
