#include "solver/run/checkpoint.hpp"

#include <algorithm>

#include "solver/kernel/time_step.hpp"
#include "solver/run/archive.hpp"

namespace leda::solver {

namespace {

// Every list below serves both ways, so that they cannot differ.

template <class Archive, class Audit>
void transfer_audit(Archive& archive, Audit& a) {
  archive("audit.kinetic_start", a.kinetic_start);
  archive("audit.kinetic", a.kinetic);
  archive("audit.kinetic_peak", a.kinetic_peak);
  archive("audit.gravity_work", a.gravity_work);
  archive("audit.damping_work", a.damping_work);
  archive("audit.stress_work", a.stress_work);
  archive("audit.transfer_loss", a.transfer_loss);
  archive("audit.elastic_start", a.elastic_start);
  archive("audit.least_scale", a.least_scale);
  archive("audit.started", a.started);
}

template <class Archive, class Clock>
void transfer_clock(Archive& archive, Clock& c) {
  archive("clock.stage", c.stage);
  archive("clock.next_look", c.next_look);
  archive("clock.next_frame", c.next_frame);
  archive("clock.still_since", c.still_since);
  archive("clock.still_kinetic", c.still_kinetic);
  archive("clock.looks", c.looks);
}

template <class Archive, class Run>
void transfer_run(Archive& archive, Run& run) {
  using Slides = std::conditional_t<std::is_const_v<Run>, const SlideCount, SlideCount>;
  SlideCount::each(static_cast<Slides&>(run.slides), archive);
  transfer_audit(archive, run.audit);
  archive("worst.mass", run.worst.mass);
  archive("worst.momentum", run.worst.momentum);
  archive("worst.energy", run.worst.energy);
  archive("numerical_dissipation", run.numerical_dissipation);
  archive("time", run.time);
  archive("rate_since", run.rate_since);
  archive("fastest", run.fastest);
  archive("steps", run.steps);
  archive("particle_steps", run.particle_steps);
  archive("travel", run.travel);
  transfer_clock(archive, run.clock);
  archive("frames", run.frames);
  archive("run_time_before", run.run_time_before);
}

// The names of the numbers that a pack holds: a pack of others is refused.
template <class Real>
std::string names_of_numbers() {
  std::string names;
  for (const auto& number : point_numbers<Real>) names += std::string(number.name) + " ";
  for (const auto& number : motion_numbers<Real>) names += std::string(number.name) + " ";
  return names;
}

template <class Archive, class AnyModelOf>
void transfer_model(Archive& archive, AnyModelOf& model) {
  auto& packs = model.packs;
  archive("packs.count", packs.count);
  archive("packs.pack", packs.pack);
  archive("packs.place", packs.place);
  archive("packs.motion", packs.motion);
  archive("packs.strayed", packs.strayed);
  archive("packs.group", packs.group);
  archive("packs.column", packs.column);
  archive("grid.top", model.grid.top);
  archive("grid.mass", model.grid.mass);  // not computed anew where ground rests
  archive("model.strayed", model.strayed);
  archive("model.kept", model.kept);
  archive("model.rest", model.rest);
  archive("model.yielded", model.yielded);
  archive("model.steps", model.steps);
  archive("model.wakes", model.wakes);
}

template <class Real>
void find_taken(Packs<Real>& packs) {
  packs.taken.assign(packs.pack.size(), 0);
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) {
      if (packs.pack[i].id[l] < 0) continue;
      packs.taken[i] = static_cast<LaneBits>(packs.taken[i] | 1U << l);
    }
  }
}

// Whether groups and columns lie within the packs.
template <class Real>
bool groups_fit(const Model<Real>& model) {
  const auto& packs = model.packs;
  if (packs.group.size() != groups_of(model.grid.columns) ||
      packs.column.size() != model.grid.columns) {
    return false;
  }
  std::size_t first = 0;
  for (const PackGroup& group : packs.group) {
    const bool fits = group.first == first && group.room <= packs.pack.size() - first &&
                      group.in_use <= group.room && group.in_order <= group.in_use;
    if (!fits) return false;
    first += group.room;
  }
  return first == packs.pack.size() &&
         std::ranges::all_of(packs.column, [&](const PackColumn& column) {
           return column.first <= packs.pack.size() && column.rows <= model.grid.rows;
         });
}

// Whether a saved model is one of this case: on this grid, with ids that were seeded.
template <class Real>
bool fits(const Model<Real>& model, std::size_t seeded, std::size_t laws) {
  const auto& packs = model.packs;
  const bool keeps_mass = model.settings.softer || model.grid.band.exists();
  const std::size_t mass = keeps_mass ? model.grid.columns * model.grid.stride : 0;
  const std::size_t size = packs.pack.size();
  if (packs.place.size() != size || packs.motion.size() != size || packs.strayed.size() != size ||
      !model.kept || model.grid.top.size() != model.grid.columns ||
      model.grid.mass.size() != mass || model.rest.size() != groups_of(model.grid.columns) ||
      model.yielded.size() != model.rest.size() || !groups_fit(model)) {
    return false;
  }
  std::size_t points = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (packs.place[i].column + 3 > model.grid.columns || packs.place[i].row >= model.grid.rows) {
      return false;
    }
    for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) {
      const std::int32_t id = packs.pack[i].id[l], law = packs.pack[i].law[l];
      if (id >= static_cast<std::int32_t>(seeded)) return false;
      if (law < 0 || law >= static_cast<std::int32_t>(laws)) return false;
      if (id >= 0) ++points;
    }
  }
  return points == packs.count && std::ranges::all_of(model.grid.top, [&](std::size_t top) {
           return top <= model.grid.rows;
         });
}

template <class Real>
bool read_model(Reader& reader, RunState& run) {
  std::string names;
  reader("numbers", names);
  if (!reader.good() || names != names_of_numbers<Real>()) return false;
  auto model = empty_model<Real>(run.seeded.size, laws_now(run), moving_settings(run));
  transfer_model(reader, model);
  const std::size_t seeded = run.seeded.start_x.size(), laws = run.seeded.laws.rows();
  if (!reader.good() || !fits(model, seeded, laws)) return false;
  find_taken(model.packs);
  spread_all(model);
  run.model = std::move(model);
  return true;
}

}  // namespace

std::string save_state(const RunState& run) {
  const auto write = [&](auto& archive) {
    archive("laws", std::uint64_t{run.seeded.laws.rows()});
    archive("double", std::holds_alternative<Model<double>>(run.model));
    archive("warnings", std::uint64_t{run.warnings.size()});
    for (const std::string& warning : run.warnings) archive("warning", warning);
    transfer_run(archive, run);
    with_model(run.model, [&]<class Real>(const Model<Real>& model) {
      archive("numbers", names_of_numbers<Real>());
      transfer_model(archive, model);
    });
  };
  Counter counter;
  write(counter);
  Writer writer(counter.bytes());
  write(writer);
  return writer.take();
}

bool load_state(const std::string& bytes, RunState& run) {
  Reader reader(bytes);
  std::uint64_t rows = 0, warnings = 0;
  bool is_double = false;
  reader("laws", rows);
  reader("double", is_double);
  reader("warnings", warnings);
  if (!reader.good() || rows != run.seeded.laws.rows() ||
      is_double != (run.settings->precision == Precision::double_precision)) {
    return false;
  }
  RunState read = run;
  read.warnings.clear();
  for (std::uint64_t i = 0; i < warnings && reader.good(); ++i) {
    reader("warning", read.warnings.emplace_back());
  }
  transfer_run(reader, read);
  const bool fits = is_double ? read_model<double>(reader, read) : read_model<float>(reader, read);
  if (!fits || !reader.at_end()) return false;
  run = std::move(read);
  run.resumed = true;
  return true;
}

}  // namespace leda::solver
