#pragma once
// The map page as an answer.

#include "server/http/answer.hpp"

namespace leda::server {

/// Whether this program was built with the page.
bool has_page();

/// The page's document, with the policy that keeps it to this server's own files. It says nothing
/// that a token protects: the token is entered in it.
Answer page_answer(const Call& call);

}  // namespace leda::server
