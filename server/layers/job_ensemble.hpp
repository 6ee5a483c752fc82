#pragma once
// The ensembles of a job of the store: what its members say of each of its sections.

#include <optional>
#include <variant>
#include <vector>

#include "db/store.hpp"
#include "profiles/map/profile.hpp"
#include "server/documents/ensemble_document.hpp"
#include "server/documents/region_request.hpp"

namespace leda::server {

/// Whether a section or a member neither waits nor runs.
bool has_ended(const db::SectionRecord& section);

/// The run of a member's row. @pre the record is a member's
MemberRun run_of(const db::SectionRecord& member);

/// The other way round.
db::MemberRecord member_of(const db::SectionRecord& section, const MemberRun& run);

/// The ground of a section, or of the one that a member is of, as the map knows it.
Profile profile_of(const db::SectionRecord& section);

/// What a section's draws depend on. @param soil models of a region; empty: a case
solver::Place place_of(const db::SectionRecord& section, const std::vector<SoilModel>& soil);

/// What the members of a section said when so many of them were looked at.
struct Look {
  std::size_t members = 0;
  solver::EnsembleSummary summary;
};

/// The look that ended the ensemble, else the last one that is over; nothing before the first.
/// @param members of one section, by ordinal
std::optional<Look> last_look(const Ensemble& ensemble, const solver::Place& place,
                              const std::vector<db::SectionRecord>& members);

struct EnsembleOfSection {
  std::vector<MemberRow> rows;              ///< of runs that ended
  std::optional<SectionEnsemble> ensemble;  ///< absent before the first look
};

/// Belongs to one thread.
class JobEnsemble {
 public:
  /// From the request in the store; nothing where the job has no ensemble.
  static std::optional<JobEnsemble> of(const db::Store& store, const db::JobStatus& job);

  const Ensemble& asked() const;
  /// Models of a region; empty for a case.
  const std::vector<SoilModel>& soil() const;

  EnsembleOfSection of_section(const db::SectionRecord& section) const;

 private:
  JobEnsemble(const db::Store& store, std::variant<EnsembleCase, RegionRequest> request);

  const db::Store* store_;
  std::variant<EnsembleCase, RegionRequest> request_;
};

/// Of those sections whose first look is over; none where the job has no ensemble.
std::vector<SectionEnsemble> ensembles_of(const db::Store& store, const db::JobStatus& job,
                                          const std::vector<db::SectionRecord>& sections);

/// The same as JobEnsemble::of(). @throws Problem no_such_result where the job has no ensemble
JobEnsemble ensemble_or_problem(const db::Store& store, const db::JobStatus& job);

}  // namespace leda::server
