#pragma once
// An answer through cpp-httplib: text, a file piece by piece, or a stream of events.

#include <httplib.h>

#include "server/http/answer.hpp"
#include "server/jobs/service.hpp"

namespace leda::server {

/// Takes the body out of the answer.
/// @throws std::runtime_error where the file of an answer cannot be read
void send(Service& service, Answer& answer, httplib::Response& response);

}  // namespace leda::server
