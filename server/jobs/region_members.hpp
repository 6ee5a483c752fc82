#pragma once
// Members of the sections of a region: their cases, checked before anything is stored, and the
// zones that they say together.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "db/store.hpp"
#include "profiles/zonation.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/region_request.hpp"
#include "server/jobs/ensemble_members.hpp"

namespace leda::server {

/// Members that are read as cases before a job is stored; of more than that, every n-th.
inline constexpr std::size_t most_checked_members = 2048;

/// Belongs to one thread.
class RegionMembers {
 public:
  /// @pre the request has an ensemble
  RegionMembers(const RegionRequest& request, const db::Store& store)
      : request_(request), store_(store), looks_(store) {}

  const solver::EnsemblePlan& plan() const { return request_.ensemble->asked.plan; }

  /// What is wrong with members of the sections that wait, each fault once.
  /// @param request as sent, where faults point to
  std::vector<Fault> check(const std::vector<db::SectionRecord>& sections,
                           const nlohmann::json& request) const;

  /// The case of a member, or why what it draws can't be run: pointers into the inputs.
  Parsed<CaseFile> case_of(const db::SectionRecord& member) const;

  std::string not_needed(const db::SectionRecord& member);

  /// Release and runout zones at each exceedance, nested.
  std::vector<Zone> zones(const std::vector<db::SectionRecord>& sections,
                          const profiles::ZonationOptions& options) const;

 private:
  /// @return the case, or what is wrong with it in pointers of the request
  Parsed<CaseFile> read_case(const db::SectionRecord& member, const nlohmann::json& request) const;

  const RegionRequest& request_;
  const db::Store& store_;
  EnsembleLooks looks_;
};

}  // namespace leda::server
