#pragma once

namespace leda::server {

/// "0.1.0", as CMakeLists.txt says.
const char* version();

}  // namespace leda::server
