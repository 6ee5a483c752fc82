#pragma once

namespace leda::server {

/// "0.2.0+g1a2b3c4d": the project's version and the commit, "-dirty" after it where the checkout
/// held changes that were not committed. Without the commit where no checkout was built.
const char* version();

}  // namespace leda::server
