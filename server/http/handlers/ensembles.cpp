#include <nlohmann/json.hpp>

#include "server/drawings/ensemble_drawing.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/router.hpp"
#include "server/http/site.hpp"
#include "server/layers/compare_sections.hpp"
#include "server/layers/job_ensemble.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {

Answer get_section_ensemble(Site& site, const Call& call) {
  const bool drawing = format(call, {"json", "svg"}) == "svg";
  const db::Store& store = site.service.store;
  const auto job = job_status_or_problem(store, call.captured[0]);
  const auto ensemble = ensemble_or_problem(store, job);
  const auto section = sections_or_problem(store, job.id, {call.captured[1]}).front();
  const auto of_section = ensemble.of_section(section).ensemble;
  if (!of_section) {
    throw Problem(Failure::result_not_ready,
                  "the first members of section '" + section.name +
                      "' are not over: " + (section.reason.empty() ? job.message : section.reason));
  }
  if (!drawing) return json_answer(to_document(*of_section));
  Answer answer;
  answer.type = "image/svg+xml";
  answer.body = ensemble_svg({*of_section});
  return answer;
}

Answer get_members(Site& site, const Call& call) {
  format(call, {"csv"});
  const db::Store& store = site.service.store;
  const auto job = job_status_or_problem(store, call.captured[0]);
  const auto ensemble = ensemble_or_problem(store, job);
  if (!db::is_final(job.state)) {  // a table of those that ended would look like all of them
    throw Problem(Failure::result_not_ready,
                  "job " + job.id + " is " + db::to_string(job.state) + ": " + job.message +
                      "; what its members say so far stands at sections/{name}/ensemble");
  }
  const db::Turns::Turn turn(site.pages);
  Answer answer;
  answer.type = "text/csv";
  answer.body = members_csv_head(ensemble.asked().asked.plan.inputs);
  for (const auto& section : store.sections(job.id)) {
    for (const MemberRow& row : ensemble.of_section(section).rows) {
      answer.body += members_csv_line(row);
    }
  }
  return answer;
}

}  // namespace leda::server
