// In place of the bundled files where there is no Node.js or npm.

#include "server/page/page_files.hpp"

namespace leda::server {

std::span<const PageFile> page_files() { return {}; }

}  // namespace leda::server
