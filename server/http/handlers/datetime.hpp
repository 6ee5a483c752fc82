#pragma once
// datetime= as OGC API writes it.

#include <optional>
#include <string>

#include "server/http/answer.hpp"

namespace leda::server {

/// Times from and to, both included, UTC; empty: open. A day is the whole of it.
struct Interval {
  std::string from, to;
};
/// A time, or FROM/TO with ".." or nothing for an open end. @throws Problem
Interval interval(const Call& call);

/// A time as RFC 3339 writes it ("2026-01-31T12:00:00Z", "...+01:00") in UTC, with Z; nothing
/// where it is none.
std::optional<std::string> utc_from(const std::string& time);

/// Whether a text is a day that the calendar has, "2026-01-31".
bool is_day(const std::string& text);

}  // namespace leda::server
