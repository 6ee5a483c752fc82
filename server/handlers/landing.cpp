#include <nlohmann/json.hpp>

#include "server/handlers/handlers.hpp"
#include "server/handlers/parameters.hpp"
#include "server/routes.hpp"
#include "server/service.hpp"
#include "server/version.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

constexpr const char* ogc_rel = "http://www.opengis.net/def/rel/ogc/1.0/";

json links_of(const std::string& url) {
  const auto link = [&](const std::string& path, const std::string& rel, const std::string& type,
                        const std::string& title) {
    return json{{"href", url + path}, {"rel", rel}, {"type", type}, {"title", title}};
  };
  return {
      link("/", "self", "application/json", "This page"),
      link("/?f=html", "alternate", "text/html", "This page for people"),
      link("/api", "service-desc", "application/vnd.oai.openapi+json;version=3.0", "The interface"),
      link("/conformance", "conformance", "application/json", "Conformance classes"),
      link("/collections", "data", "application/json", "Sections and zones"),
      link("/processes", std::string(ogc_rel) + "processes", "application/json", "Processes"),
      link("/jobs", std::string(ogc_rel) + "job-list", "application/json", "Jobs"),
      link("/rasters", "related", "application/json", "Registered DEMs")};
}

std::string html_page(const json& links) {
  std::string page =
      "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>Leda</title>"
      "</head><body><h1>Leda</h1><p>Hazard maps of retrogressive landslides in sensitive "
      "clays.</p><ul>";
  for (const auto& link : links) {
    page += "<li><a href=\"" + link["href"].get<std::string>() + "\">" +
            link["title"].get<std::string>() + "</a></li>";
  }
  return page + "</ul></body></html>\n";
}

/// OpenAPI wants one entry for each {…} of a path and each query parameter.
json parameters_of(const Route& route) {
  json parameters = json::array();
  const auto add = [&](std::string_view name, const char* in) {
    parameters.push_back({{"name", name},
                          {"in", in},
                          {"required", std::string_view(in) == "path"},
                          {"schema", {{"type", "string"}}}});
  };
  std::string_view path = route.path;
  for (auto open = path.find('{'); open != std::string_view::npos; open = path.find('{')) {
    const auto close = path.find('}');
    add(path.substr(open + 1, close - open - 1), "path");
    path.remove_prefix(close + 1);
  }
  std::string_view rest = route.parameters;
  while (!rest.empty()) {
    const auto blank = std::min(rest.find(' '), rest.size());
    add(rest.substr(0, blank), "query");
    rest.remove_prefix(std::min(blank + 1, rest.size()));
  }
  return parameters;
}

json body_of(const Route& route) {
  if (route.path == "/rasters") {
    return {
        {"required", true},
        {"content", {{"image/tiff", {{"schema", {{"type", "string"}, {"format", "binary"}}}}}}}};
  }
  return {{"required", true},
          {"content", {{"application/json", {{"schema", {{"type", "object"}}}}}}}};
}

}  // namespace

Answer get_landing(Service& service, const Call& call) {
  format(call, {"json", "html"});
  const json links = links_of(service.url);
  if (wants_html(call)) {
    Answer answer;
    answer.type = "text/html; charset=utf-8";
    answer.body = html_page(links);
    answer.headers.emplace_back("Vary", "Accept");
    return answer;
  }
  Answer answer =
      json_answer({{"title", "Leda"},
                   {"description", "Hazard maps of retrogressive landslides in sensitive clays"},
                   {"links", links}});
  answer.headers.emplace_back("Vary", "Accept");
  return answer;
}

Answer get_conformance(Service&, const Call& call) {
  format(call, {"json"});
  json classes = json::array();
  for (const char* name :
       {"core", "ogc-process-description", "json", "oas30", "job-list", "dismiss"}) {
    classes.push_back(std::string("http://www.opengis.net/spec/ogcapi-processes-1/1.0/conf/") +
                      name);
  }
  for (const char* name : {"core", "geojson", "oas30"}) {
    classes.push_back(std::string("http://www.opengis.net/spec/ogcapi-features-1/1.0/conf/") +
                      name);
  }
  return json_answer({{"conformsTo", classes}});
}

Answer get_api(Service& service, const Call& call) {
  format(call, {"json"});
  json paths = json::object();
  for (const Route& route : routes()) {
    json operation = {
        {"summary", route.summary},
        {"parameters", parameters_of(route)},
        {"responses", {{"default", {{"description", "The answer, or a problem (RFC 9457)"}}}}}};
    std::string verb(route.method);
    for (char& c : verb) c = static_cast<char>(c - 'A' + 'a');
    if (route.method == "POST" && route.path != "/jobs/{jobID}/retry") {
      operation["requestBody"] = body_of(route);
    }
    paths[std::string(route.path)][verb] = operation;
  }
  Answer answer = json_answer({{"openapi", "3.0.3"},
                               {"info", {{"title", "Leda"}, {"version", version()}}},
                               {"servers", json::array({{{"url", service.url}}})},
                               {"paths", paths}});
  answer.type = "application/vnd.oai.openapi+json;version=3.0";
  return answer;
}

}  // namespace leda::server
