#pragma once
// The texts of schema/*.json, put into the binary when it is built.

namespace leda::server {

extern const char* const definitions_schema_text;
extern const char* const case_schema_text;
extern const char* const hindcast_request_schema_text;
extern const char* const region_schema_text;
extern const char* const resolution_study_request_schema_text;
extern const char* const api_schema_text;

}  // namespace leda::server
