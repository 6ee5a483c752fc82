#pragma once
// Query parameters that several handlers share.

#include <cstdint>
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

/// One of some words, the first where it is not given.
/// @throws Problem invalid_parameter where it is none of these
std::string choice(const Call& call, const std::string& name,
                   const std::vector<std::string>& known);

/// A number of seconds, 0 or more; nothing where it is not given.
std::optional<double> seconds(const Call& call, const std::string& name);

/// Whether If-None-Match names this tag (or any), so that the client has the answer already.
bool has_already(const Call& call, const std::string& tag);

/// The answer to has_already(): 304 with the tag.
Answer not_modified(const std::string& tag);

/// Where a page begins: after the item that cursor= of a `next` link stands for; 0: at the start.
/// @throws Problem invalid_parameter
std::int64_t page_start(const Call& call);

/// The same call for the page after an item, for a `next` link.
/// @param last of this page; 0: the first page
std::string page_after(const Call& call, const std::string& path, std::int64_t last);

}  // namespace leda::server
