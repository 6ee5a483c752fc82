#include <nlohmann/json.hpp>

#include "server/http/gate.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/page.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/openapi.hpp"
#include "server/http/site.hpp"

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

/// For people where the program was built without the map page.
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

}  // namespace

Answer get_landing(Site& site, const Call& call) {
  const bool for_people = format(call, {"json", "html"}) == "html";
  if (for_people && has_page()) return page_answer(call);
  require_role(Role::read, call.header, site.tokens);
  const json links = links_of(site.url);
  if (for_people) {
    Answer answer;
    answer.type = "text/html; charset=utf-8";
    answer.body = html_page(links);
    return answer;
  }
  return json_answer({{"title", "Leda"},
                      {"description", "Hazard maps of retrogressive landslides in sensitive clays"},
                      {"links", links}});
}

Answer get_conformance(Site& /*site*/, const Call& call) {
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

Answer get_api(Site& site, const Call& call) {
  format(call, {"json"});
  Answer answer = json_answer(openapi_document(site.url, site.tokens.required()));
  answer.type = "application/vnd.oai.openapi+json;version=3.0";
  return answer;
}

}  // namespace leda::server
