#pragma once
// An answer through cpp-httplib: text, a file piece by piece, parts of either, or a stream of
// events.

#include <httplib.h>

#include "server/http/answer.hpp"
#include "server/http/site.hpp"

namespace leda::server {

/// Takes the body out of the answer. Where the request asks for ranges of a success, the status is
/// 206, or 416 where there are no such bytes.
/// @throws std::runtime_error where the file of an answer cannot be read
void send(Site& site, const httplib::Request& request, Answer& answer, httplib::Response& response);

}  // namespace leda::server
