#include "server/http/handlers/datetime.hpp"

#include <gtest/gtest.h>

#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

Interval of(const std::string& datetime) {
  Call call;
  call.query = {{"datetime", datetime}};
  return interval(call);
}

TEST(Datetime, ADayIsTheWholeOfIt) {
  EXPECT_EQ(of("2026-01-31").from, "2026-01-31T00:00:00Z");
  EXPECT_EQ(of("2026-01-31").to, "2026-01-31T23:59:59.999Z");
}

TEST(Datetime, TimesAreToldInUtc) {
  EXPECT_EQ(utc_from("2026-01-31T12:00:00Z"), "2026-01-31T12:00:00.000Z");
  EXPECT_EQ(utc_from("2026-01-01T00:30:00.25+01:00"), "2025-12-31T23:30:00.250Z");
  EXPECT_EQ(utc_from("2024-02-29T23:59:59-05:30"), "2024-03-01T05:29:59.000Z");
}

TEST(Datetime, AnEndMayBeOpen) {
  for (const char* open : {"..", ""}) {
    EXPECT_EQ(of("2026-01-31/" + std::string(open)).to, "");
    EXPECT_EQ(of(std::string(open) + "/2026-01-31").from, "");
  }
}

TEST(Datetime, AnIntervalThatEndsBeforeItBeginsIsRefused) {
  EXPECT_THROW(of("2026-02-01/2026-01-01"), Problem);
  EXPECT_THROW(of("2026-01-31T12:00:00Z/2026-01-31T11:59:59.5Z"), Problem);
  EXPECT_NO_THROW(of("2026-01-31/2026-01-31"));
  EXPECT_NO_THROW(of("2026-01-31/2026-01-31T00:00:00Z"));
  EXPECT_NO_THROW(of("2026-01-31T12:00:00+01:00/2026-01-31T11:00:00Z"));
}

TEST(Datetime, WhatTheCalendarDoesNotHaveIsRefused) {
  for (const char* bad :
       {"", "..", "yesterday", "2026-02-30", "2025-02-29", "2026-13-01", "2026-1-1", "26-01-01",
        "2026-01-31T24:00:00Z", "2026-01-31T12:61:00Z", "2026-01-31T12:00:00",
        "2026-01-31 12:00:00Z", "2026-01-31T1:00:00Z", "2026-01-31T12:00:00+0100",
        "2026-01-31T12:00:00+01:00x", "2026-01-31x", "2026-01-31T12:00:00ZZ"}) {
    EXPECT_THROW(of(bad), Problem) << bad;
  }
}

}  // namespace
}  // namespace leda::server
