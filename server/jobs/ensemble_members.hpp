#pragma once
// Members of the sections of a job: their rows, and how many of them are run.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "server/documents/ensemble_case.hpp"

namespace leda::server {

/// Adds the members of every section that waits: all members of the first look, section by section,
/// then those of the second.
void add_members(std::vector<db::SectionRecord>& sections, const solver::EnsemblePlan& plan);

/// Whether a member is beyond the first look, so that it may turn out not to be needed.
bool is_beyond_first_look(const db::SectionRecord& section, const solver::EnsemblePlan& plan);

/// The resolution of a run of a section by itself, or of a member of it.
Resolution resolution_of(const db::SectionRecord& section, const Resolution& given,
                         const std::optional<solver::CheckRule>& check);

/// Ends the ensemble of a section at the look that is sure enough. Belongs to one thread.
class EnsembleLooks {
 public:
  explicit EnsembleLooks(const db::Store& store) : store_(store) {}

  /// Why a member is not run any more; empty: it is.
  std::string not_needed(const Ensemble& ensemble, const solver::Place& place,
                         const db::SectionRecord& member);

 private:
  struct OfSection {
    std::size_t looked_at = 0;            ///< members of the last look
    std::optional<std::size_t> ended_at;  ///< and of the one that was sure enough
    /// A member that the next look waits for: while it goes on no other is read. 0: none.
    std::int64_t waits_for = 0;
  };

  void look(const Ensemble& ensemble, const solver::Place& place, const db::SectionRecord& member,
            OfSection& of) const;

  const db::Store& store_;
  std::map<int, OfSection> by_section_;
};

}  // namespace leda::server
