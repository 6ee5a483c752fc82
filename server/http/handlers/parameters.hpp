#pragma once
// Query parameters that several handlers share.

#include <optional>
#include <string>
#include <vector>

#include "server/http/answer.hpp"

namespace leda::server {

/// An integer between `least` and `most`; `absent` where it is not given.
/// @throws Problem invalid_parameter naming it
int whole_number(const Call& call, const std::string& name, int absent, int least, int most);

/// The parts of a comma-separated value; empty where it is not given.
std::vector<std::string> list(const Call& call, const std::string& name);

/// Whether the client wants HTML rather than JSON: by f=, else by its Accept header.
bool wants_html(const Call& call);

/// Refuses an f= that is none of these. @return f, or the first where it is not given
std::string format(const Call& call, const std::vector<std::string>& known);

/// A number of seconds, 0 or more; nothing where it is not given.
std::optional<double> seconds(const Call& call, const std::string& name);

/// Whether If-None-Match names this tag (or any), so that the client has the answer already.
bool has_already(const Call& call, const std::string& tag);

/// The answer to has_already(): 304 with the tag.
Answer not_modified(const std::string& tag);

/// A time as RFC 3339 writes it, or its date alone.
bool is_datetime(const std::string& text);

/// The same call with another offset, for a `next` link.
std::string with_offset(const Call& call, const std::string& path, int offset);

}  // namespace leda::server
