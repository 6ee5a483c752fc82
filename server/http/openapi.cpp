#include "server/http/openapi.hpp"

#include <cctype>
#include <nlohmann/json.hpp>

#include "server/documents/openapi_schema.hpp"
#include "server/http/routes.hpp"
#include "server/jobs/process.hpp"
#include "server/operate/version.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

json reference(std::string_view schema) {
  return {{"$ref", "#/components/schemas/" + std::string(schema)}};
}

/// OpenAPI wants one entry for each {…} of a path.
void add_path_parameters(json& parameters, std::string_view path) {
  for (auto open = path.find('{'); open != std::string_view::npos; open = path.find('{')) {
    const auto close = path.find('}');
    parameters.push_back({{"name", path.substr(open + 1, close - open - 1)},
                          {"in", "path"},
                          {"required", true},
                          {"schema", {{"type", "string"}}}});
    path.remove_prefix(close + 1);
  }
}

json parameters_of(const Route& route) {
  json parameters = json::array();
  add_path_parameters(parameters, route.path);
  std::string_view rest = route.parameters;
  while (!rest.empty()) {
    const auto blank = std::min(rest.find(' '), rest.size());
    parameters.push_back(
        {{"$ref", "#/components/parameters/" + std::string(rest.substr(0, blank))}});
    rest.remove_prefix(std::min(blank + 1, rest.size()));
  }
  return parameters;
}

/// `answer` of a route: names of schemas and media types, separated by blanks.
json content_of(std::string_view answer) {
  json content = json::object();
  while (!answer.empty()) {
    const auto blank = std::min(answer.find(' '), answer.size());
    const std::string name(answer.substr(0, blank));
    if (name.find('/') != std::string::npos) {
      content[name] = {{"schema", {{"type", "string"}}}};
    } else if (name.starts_with("feature")) {
      content["application/geo+json"] = {{"schema", reference(name)}};
    } else {
      content["application/json"] = {{"schema", reference(name)}};
    }
    answer.remove_prefix(std::min(blank + 1, answer.size()));
  }
  return content;
}

json problem_answer(const char* description) {
  return {{"description", description},
          {"content", {{"application/problem+json", {{"schema", reference("problem")}}}}}};
}

json answers_of(const Route& route) {
  const bool creates =
      route.path.ends_with("/execution") || (route.method == "POST" && route.path == "/rasters");
  json answers;
  const char* status = creates ? "201" : route.answer.empty() ? "204" : "200";
  answers[status]["description"] = route.summary;
  if (!route.answer.empty()) answers[status]["content"] = content_of(route.answer);
  if (route.path.ends_with("/execution")) {
    answers["200"] = {{"description", "the estimate, where dryRun was asked for"},
                      {"content", content_of("estimate")}};
    answers["429"] = problem_answer("too many jobs are unfinished; see Retry-After");
  }
  answers["default"] = problem_answer("a problem");
  return answers;
}

json body_of(const std::string& schema) {
  return {{"required", true}, {"content", {{"application/json", {{"schema", reference(schema)}}}}}};
}

/// "get_jobs_jobID"
std::string operation_id(const Route& route, const std::string& path) {
  std::string id;
  for (const char c : std::string(route.method) + path) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      id += c;
    } else if (!id.empty() && id.back() != '_' && c != '}') {
      id += '_';
    }
  }
  while (id.ends_with('_')) id.pop_back();
  for (std::size_t i = 0; i < route.method.size(); ++i) {
    id[i] = static_cast<char>(std::tolower(static_cast<unsigned char>(id[i])));
  }
  return id;
}

json operation_of(const Route& route, const std::string& path) {
  json operation = {{"summary", route.summary},
                    {"operationId", operation_id(route, path)},
                    {"parameters", parameters_of(route)},
                    {"responses", answers_of(route)}};
  if (route.role == Role::anyone) operation["security"] = json::array();
  if (route.method == "POST" && route.path == "/rasters") {
    operation["requestBody"] = {
        {"required", true},
        {"content", {{"image/tiff", {{"schema", {{"type", "string"}, {"format", "binary"}}}}}}}};
  }
  if (route.path.ends_with("/layout")) {
    operation["requestBody"] = body_of("layoutRequest");
  }
  if (route.method == "PATCH") {
    operation["requestBody"] = body_of("rasterName");
  }
  return operation;
}

/// An execution has a body of its own for every process, so each has a path of its own.
void add_executions(json& paths, const Route& route) {
  for (const Process& process : processes()) {
    const std::string path = "/processes/" + std::string(process.id) + "/execution";
    json operation = operation_of(route, path);
    operation["summary"] = process.title;
    operation["parameters"] =
        json::array({{{"name", "Idempotency-Key"},
                      {"in", "header"},
                      {"description", "the same key and body again give the same job"},
                      {"schema", {{"type", "string"}, {"maxLength", 128}}}}});
    operation["requestBody"] = body_of(std::string(process.id) + "-request");
    paths[path]["post"] = operation;
  }
}

json components() {
  json parameters = openapi_parameters();
  for (const auto& [name, parameter] : parameters.items()) {
    parameter["name"] = name;
    parameter["in"] = "query";
  }
  return {{"schemas", openapi_schemas()}, {"parameters", parameters}};
}

}  // namespace

json openapi_document(const std::string& url, bool with_tokens) {
  json paths = json::object();
  for (const Route& route : routes()) {
    if (route.path.ends_with("/execution")) {
      add_executions(paths, route);
      continue;
    }
    std::string verb(route.method);
    for (char& c : verb) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    paths[std::string(route.path)][verb] = operation_of(route, std::string(route.path));
  }
  json document = {{"openapi", "3.0.3"},
                   {"info",
                    {{"title", "Leda"},
                     {"description", "Hazard maps of retrogressive landslides in sensitive clays"},
                     {"version", version()}}},
                   {"servers", json::array({{{"url", url}}})},
                   {"paths", paths},
                   {"components", components()}};
  if (with_tokens) {
    document["components"]["securitySchemes"]["token"] = {{"type", "http"}, {"scheme", "bearer"}};
    document["security"] = json::array({{{"token", json::array()}}});
  }
  return document;
}

}  // namespace leda::server
