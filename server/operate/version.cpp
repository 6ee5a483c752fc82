#include "server/operate/version.hpp"

namespace leda::server {

const char* version() { return LEDA_VERSION; }

}  // namespace leda::server
