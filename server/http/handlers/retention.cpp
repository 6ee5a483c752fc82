#include "server/operate/retention.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

#include "server/http/handlers/handlers.hpp"
#include "server/http/site.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

double days_in(const Call& call) {
  const std::string text = call.parameter("older_than_days").value_or("");
  double days = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), days);
  if (error != std::errc{} || end != text.data() + text.size() || !(days >= 0 && days < 1e5)) {
    throw Problem(Failure::invalid_parameter,
                  "older_than_days is '" + text + "': give a number of days, for example 30");
  }
  return days;
}

bool flag(const Call& call, const std::string& name) {
  const std::string text = call.parameter(name).value_or("false");
  if (text != "true" && text != "false") {
    throw Problem(Failure::invalid_parameter, name + " is '" + text + "': give true or false");
  }
  return text == "true";
}

}  // namespace

Answer post_purge(Site& site, const Call& call) {
  const Purged purged =
      purge(site.service.data, site.service.store, days_in(call), flag(call, "jobs"));
  log_info("-", "purged jobs={} run_folders={} bytes={}", purged.jobs, purged.run_folders,
           purged.bytes);
  return json_answer(
      {{"jobs", purged.jobs}, {"run_folders", purged.run_folders}, {"bytes", purged.bytes}});
}

}  // namespace leda::server
