#include <nlohmann/json.hpp>

#include "server/drawings/ensemble_drawing.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/router.hpp"
#include "server/http/site.hpp"
#include "server/jobs/section_ensemble.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {

Answer get_section_ensemble(Site& site, const Call& call) {
  const bool drawing = format(call, {"json", "svg"}) == "svg";
  const db::Store& store = site.service.store;
  const auto job = job_or_problem(store, call.captured[0]);
  const auto of_job = ensemble_of(job, store.sections(job.id));
  if (!of_job.ensemble) {
    throw Problem(Failure::result_not_ready,
                  "the first members of job " + job.id + " are not over: " + job.message);
  }
  if (of_job.ensemble->section != call.captured[1]) {
    throw Problem(Failure::no_such_resource, "the ensemble of job " + job.id + " is of section '" +
                                                 of_job.ensemble->section + "'");
  }
  if (!drawing) return json_answer(to_document(*of_job.ensemble));
  Answer answer;
  answer.type = "image/svg+xml";
  answer.body = ensemble_svg({*of_job.ensemble});
  return answer;
}

Answer get_members(Site& site, const Call& call) {
  format(call, {"csv"});
  const db::Store& store = site.service.store;
  const auto job = job_or_problem(store, call.captured[0]);
  const auto of_job = ensemble_of(job, store.sections(job.id));
  Answer answer;
  answer.type = "text/csv";
  answer.body = members_csv_head(of_job.inputs);
  for (const MemberRow& row : of_job.rows) answer.body += members_csv_line(row);
  return answer;
}

}  // namespace leda::server
