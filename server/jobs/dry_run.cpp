#include "server/jobs/dry_run.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "server/jobs/run_size.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

json row_of(const db::SectionRecord& section) {
  return {{"name", section.name},
          {"line", section.line < 0 ? json() : json(section.line)},
          {"order_m", section.line < 0 ? json() : json(section.order)},
          {"state", db::to_string(section.state)},
          {"reason", section.reason},
          {"warnings", section.warnings},
          {"particles", nullptr}};
}

struct Sum {
  std::size_t waiting = 0, left_out = 0, screened = 0, stable = 0;
  double particles = 0, most_particles = 0, likely_s = 0, longest_s = 0, disk = 0;
  double spared_s = 0;  ///< of likely_s: runs that may turn out not to be needed

  void add(const RunCost& cost, const RunSize& size, bool may_be_spared) {
    ++waiting;
    particles += size.particles;
    most_particles = std::max(most_particles, size.particles);
    likely_s += cost.likely_core_s;
    if (may_be_spared) spared_s += cost.likely_core_s;
    longest_s += cost.longest_core_s;
    disk += cost.disk_bytes;
  }
};

/// Of a member's folder, whose fields are removed: case, result, profile and log.
constexpr double bytes_of_a_member = 40e3;

/// Sizes of the runs of a job. A member is as large as its section, unless its cells are finer.
class Sizes {
 public:
  Sizes(const Work& work, const std::vector<db::SectionRecord>& sections)
      : work_(work), sections_(sections) {}

  const RunSize& of(const db::SectionRecord& section) {
    const int of = section.member ? section.member->of : section.ordinal;
    const auto [known, is_new] = known_.try_emplace({of, kind_of(section)});
    if (is_new) {
      db::SectionRecord whole = sections_.at(static_cast<std::size_t>(of));
      whole.member = section.member;
      known->second = work_.size(whole);
    }
    return known->second;
  }

 private:
  static int kind_of(const db::SectionRecord& section) {
    if (!section.member) return 0;
    return section.member->finer ? 2 : 1;
  }

  const Work& work_;
  const std::vector<db::SectionRecord>& sections_;  ///< by ordinal
  std::map<std::pair<int, int>, RunSize> known_;
};

/// Marks a section that screening finds stable. Of many sections every n-th is looked at.
void screen(const Work& work, db::SectionRecord& section, Sum& sum) {
  const auto screened = work.screen(section);
  if (!screened) return;
  ++sum.screened;
  if (!screened->skip) return;
  ++sum.stable;
  section.state = db::SectionState::stable;
  section.reason = screened->reason;
}

std::string basis(const db::TypicalRun& typical) {
  if (typical.runs == 0) return "an ordinary core: the store holds no results yet";
  return "the median of the newest " + std::to_string(typical.runs) + " results of this store";
}

json estimate_of(const Sum& sum, const db::TypicalRun& typical) {
  // Of sections that were not looked at, as many are stable as of those that were.
  const double share =
      sum.screened == 0 ? 1
                        : 1 - static_cast<double>(sum.stable) / static_cast<double>(sum.screened);
  return {{"runs", std::llround(static_cast<double>(sum.waiting) * share)},
          {"left_out", sum.left_out},
          {"screened", sum.screened},
          {"stable", std::llround(static_cast<double>(sum.waiting) * (1 - share))},
          {"particles", std::round(sum.particles * share)},
          {"most_particles_of_a_run", std::round(sum.most_particles)},
          {"core_hours_at_least", (sum.likely_s - sum.spared_s) * share / 3600},
          {"core_hours", sum.likely_s * share / 3600},
          {"core_hours_at_most", sum.longest_s / 3600},
          {"disk_bytes", std::round(sum.disk * share)},
          {"based_on", basis(typical)}};
}

}  // namespace

json dry_run(const Process& process, const Work& work, std::vector<db::SectionRecord> sections,
             const db::Store& store) {
  const db::TypicalRun typical = typical_or_default(store.typical_run());
  const auto own = static_cast<std::size_t>(
      std::ranges::count_if(sections, [](const auto& section) { return !section.member; }));
  const std::size_t every = own / most_screened_in_a_dry_run + 1;
  Sizes sizes(work, sections);
  Sum sum;
  json rows = json::array();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    auto& section = sections[i];
    json particles;
    if (section.state == db::SectionState::waiting) {
      const RunSize& size = sizes.of(section);
      RunCost cost = cost_of(size, typical);
      if (section.member) cost.disk_bytes = bytes_of_a_member;
      sum.add(cost, size, work.may_be_spared(section));
      particles = std::round(size.particles);
      if (i % every == 0 && !section.member) screen(work, section, sum);
    } else {
      ++sum.left_out;
    }
    if (section.member) continue;
    rows.push_back(row_of(section));
    rows.back()["particles"] = particles;
  }
  return {{"dryRun", true},
          {"processID", process.id},
          {"warnings", work.warnings()},
          {"sections", rows},
          {"estimate", estimate_of(sum, typical)}};
}

double particles_of(const Work& work, const std::vector<db::SectionRecord>& sections) {
  Sizes sizes(work, sections);
  double particles = 0;
  for (const auto& section : sections) {
    if (section.state == db::SectionState::waiting) particles += sizes.of(section).particles;
  }
  return particles;
}

}  // namespace leda::server
