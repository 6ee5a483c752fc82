#include "server/jobs/section_ensemble.hpp"

#include <utility>

#include "server/jobs/ensemble_members.hpp"
#include "server/jobs/without_map.hpp"
#include "server/layers/job_ensemble.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

using db::SectionRecord;

class SectionEnsembleJob final : public WithoutMap {
 public:
  SectionEnsembleJob(EnsembleCase ensemble, const db::Store& store)
      : ensemble_(std::move(ensemble)), looks_(store) {}

  std::vector<SectionRecord> plan() const override {
    std::vector<SectionRecord> sections{record_of(ensemble_.of.section)};
    sections[0].warnings = warnings_of(ensemble_.of.section, ensemble_.of.settings);
    add_members(sections, ensemble_.asked.plan);
    return sections;
  }

  std::string case_file(const SectionRecord& section) const override {
    const auto document =
        section.member ? ensemble_.case_of(run_of(section)) : to_document(ensemble_.of);
    return document.dump(2) + "\n";
  }

  RunSize size(const SectionRecord& section) const override {
    RunSettings settings = ensemble_.of.settings;
    settings.resolution = resolution_of(section, settings.resolution, ensemble_.asked.plan.check);
    if (section.member) settings.output = Output{};
    return run_size(ensemble_.of.section, settings);
  }

  bool may_be_spared(const SectionRecord& section) const override {
    return is_beyond_first_look(section, ensemble_.asked.plan);
  }

  std::string not_needed(const SectionRecord& section) const override {
    return section.member ? looks_.not_needed(ensemble_, ensemble_.place(), section) : "";
  }

 private:
  EnsembleCase ensemble_;
  mutable EnsembleLooks looks_;  ///< of the dispatcher's thread alone
};

}  // namespace

std::unique_ptr<Work> open_section_ensemble(EnsembleCase ensemble, const db::Store& store) {
  return std::make_unique<SectionEnsembleJob>(std::move(ensemble), store);
}

}  // namespace leda::server
