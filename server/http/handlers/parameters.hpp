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

/// What to answer in: f=, else what the Accept header would rather have, else the first.
/// @throws Problem invalid_parameter where f= is none of these, not_acceptable where Accept is
std::string format(const Call& call, const std::vector<std::string>& known);

/// A number of seconds, 0 or more; nothing where it is not given.
std::optional<double> seconds(const Call& call, const std::string& name);

/// Whether If-None-Match names this tag (or any), so that the client has the answer already.
bool has_already(const Call& call, const std::string& tag);

/// The answer to has_already(): 304 with the tag.
Answer not_modified(const std::string& tag);

/// Times from and to, both included; empty: open. A day is the whole of it.
struct Interval {
  std::string from, to;
};
/// datetime=: a time, or FROM/TO with ".." or nothing for an open end. @throws Problem
Interval interval(const Call& call);

/// A time as RFC 3339 writes it, or its date alone.
bool is_datetime(const std::string& text);

/// The same call with another offset, for a `next` link.
std::string with_offset(const Call& call, const std::string& path, int offset);

}  // namespace leda::server
