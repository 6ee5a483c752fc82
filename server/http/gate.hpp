#pragma once
// Which requests are let in, decided before anything of them is read.

#include <functional>
#include <string>

#include "server/http/auth.hpp"
#include "server/http/cors.hpp"

namespace leda::server {

/// The value of a header; empty where it is absent.
using HeaderOf = std::function<std::string(const std::string&)>;

/// The name of this machine for itself: 127.0.0.1, localhost or [::1], with or without a port.
bool is_local_name(std::string host);

/// Refuses what no route wants: forms, and requests that a page of another site has a browser
/// send.
/// @param public_url of the server
/// @param origins whose pages may
/// @throws Problem
void refuse_at_the_gate(const HeaderOf& header, const Tokens& tokens, const std::string& public_url,
                        const AllowedOrigins& origins = {});

/// Who sends a request, where the role is enough for the route. Without tokens that is everybody.
/// @throws Problem no_token, role_too_low
TokenHolder require_role(Role role, const HeaderOf& header, const Tokens& tokens);

}  // namespace leda::server
