#include "solver/run/checkpoint.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "solver/kernel/time_step.hpp"

namespace leda::solver {

namespace {

constexpr std::uint64_t format = 0x4c454441'00000006;  // "LEDA", 6

// The bytes that Writer will write, so that they are asked for once.
class Counter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) { bytes_ += sizeof value; }
  template <class T>
  void operator()(const std::vector<T>& values) {
    bytes_ += sizeof(std::uint64_t);
    if constexpr (std::is_trivially_copyable_v<T>) {
      bytes_ += values.size() * sizeof(T);
    } else {
      for (const T& value : values) (*this)(value);
    }
  }
  void operator()(const std::string& text) { bytes_ += sizeof(std::uint64_t) + text.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

class Writer {
 public:
  explicit Writer(std::size_t bytes) { bytes_.reserve(bytes); }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    (*this)(std::uint64_t{values.size()});
    for (const T& value : values) (*this)(value);
  }
  void operator()(const std::vector<double>& values) { block(values); }
  void operator()(const std::vector<std::int32_t>& values) { block(values); }
  void operator()(const std::vector<Real>& values) { block(values); }
  void operator()(const std::string& text) {
    (*this)(std::uint64_t{text.size()});
    bytes_.append(text);
  }
  std::string take() { return std::move(bytes_); }

 private:
  template <class T>
  void block(const std::vector<T>& values) {
    (*this)(std::uint64_t{values.size()});
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  std::string bytes_;
};

// Reading past the end leaves the value as it was and is told by good().
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) {
    if (take(sizeof value)) std::memcpy(&value, bytes_.data() + at_ - sizeof value, sizeof value);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    const std::uint64_t count = size();
    values.clear();
    for (std::uint64_t i = 0; i < count && good_; ++i) (*this)(values.emplace_back());
  }
  void operator()(std::vector<double>& values) { block(values); }
  void operator()(std::vector<std::int32_t>& values) { block(values); }
  void operator()(std::vector<Real>& values) { block(values); }
  void operator()(std::string& text) {
    const std::uint64_t count = size();
    if (take(count)) text.assign(bytes_, at_ - count, count);
  }
  bool good() const { return good_; }
  bool at_end() const { return good_ && at_ == bytes_.size(); }

 private:
  bool take(std::uint64_t count) {
    good_ = good_ && count <= bytes_.size() - at_;
    if (good_) at_ += count;
    return good_;
  }
  std::uint64_t size() {
    std::uint64_t count = 0;
    (*this)(count);
    if (count > bytes_.size()) good_ = false;
    return good_ ? count : 0;
  }
  template <class T>
  void block(std::vector<T>& values) {
    const std::uint64_t count = size();
    if (!take(count * sizeof(T))) return;
    values.resize(count);
    // memcpy may not be given the null pointer of an empty vector.
    if (count > 0) {
      std::memcpy(values.data(), bytes_.data() + at_ - count * sizeof(T), count * sizeof(T));
    }
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

// One list for both ways, so that they cannot differ. What unpack() writes stands in the packs.
template <class Archive, class Run>
void transfer_state(Archive& archive, Run& run, bool packed) {
  auto& p = run.seeded.particles;
  if (!packed) {
    for (auto* array : {&p.x, &p.z, &p.vx, &p.vz, &p.cxx, &p.cxz, &p.czx, &p.czz, &p.sxx, &p.szz,
                        &p.sxz, &p.syy, &p.volume, &p.plastic_strain}) {
      archive(*array);
    }
  }
  for (auto* array : {&p.mass, &p.start_x, &p.start_z}) archive(*array);
  archive(p.law);
  archive(p.id);
  archive(run.seeded.grid.top);
  archive(run.slides);
  archive(run.audit);
  archive(run.worst);
  archive(run.numerical_dissipation);
  archive(run.time);
  archive(run.fastest);
  archive(run.steps);
  archive(run.particle_steps);
  archive(run.travel);
  archive(run.since_sort);
  archive(run.clock);
  archive(run.frames);
  archive(run.run_time_before);
  archive(run.warnings);
}

template <class Archive, class Stage>
void transfer_packs(Archive& archive, Stage& stage) {
  archive(stage.packs.count);
  archive(stage.packs.pack);
  archive(stage.packs.place);
  archive(stage.packs.motion);
  archive(stage.packs.strayed);
  archive(stage.packs.group);
  archive(stage.packs.column);
  archive(stage.grid.top);
  archive(stage.grid.mass);  // of ground at rest it is not found anew
  archive(stage.strayed);
  archive(stage.kept);
  archive(stage.rest);
  archive(stage.steps);
  archive(stage.wakes);
}

void find_taken(Packs& packs) {
  packs.taken.assign(packs.pack.size(), 0);
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    for (std::size_t l = 0; l < Pack::lanes; ++l) {
      if (packs.pack[i].particle[l] < 0) continue;
      packs.taken[i] = static_cast<LaneBits>(packs.taken[i] | 1U << l);
    }
  }
}

// Whether groups and columns lie within the packs.
bool groups_fit(const PackedStage& stage) {
  const Packs& packs = stage.packs;
  if (packs.group.size() != groups_of(stage.grid) || packs.column.size() != stage.grid.columns) {
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
           return column.first <= packs.pack.size() && column.rows <= stage.grid.rows;
         });
}

// Whether saved packs are packs of these particles on this grid.
bool packs_fit(const PackedStage& stage, const Particles& particles) {
  const Packs& packs = stage.packs;
  if (packs.count != particles.count || packs.place.size() != packs.pack.size() ||
      packs.motion.size() != packs.pack.size() || !stage.kept ||
      packs.strayed.size() != packs.pack.size() || stage.grid.top.size() != stage.grid.columns ||
      stage.grid.mass.size() != (stage.laws.softer ? stage.grid.columns * stage.grid.stride : 0) ||
      stage.rest.size() != groups_of(stage.grid) || !groups_fit(stage)) {
    return false;
  }
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    if (packs.place[i].column + 3 > stage.grid.columns || packs.place[i].row >= stage.grid.rows) {
      return false;
    }
    for (const std::int32_t particle : packs.pack[i].particle) {
      if (particle >= static_cast<std::int32_t>(particles.count)) return false;
    }
  }
  return std::ranges::all_of(stage.grid.top,
                             [&](std::size_t top) { return top <= stage.grid.rows; });
}

}  // namespace

std::string save_state(const RunState& run) {
  const auto write = [&](auto& archive) {
    archive(format);
    archive(std::uint64_t{run.seeded.laws.rows()});
    archive(run.packed.has_value());
    archive(std::uint64_t{run.seeded.particles.count});
    transfer_state(archive, run, run.packed.has_value());
    if (run.packed) transfer_packs(archive, *run.packed);
  };
  Counter counter;
  write(counter);
  Writer writer(counter.bytes());
  write(writer);
  return writer.take();
}

bool load_state(const std::string& bytes, RunState& run) {
  Reader reader(bytes);
  std::uint64_t found = 0, rows = 0, count = 0;
  bool packed = false;
  reader(found);
  reader(rows);
  reader(packed);
  reader(count);
  if (!reader.good() || found != format || rows != run.seeded.laws.rows() ||
      count > run.seeded.particles.count) {
    return false;
  }
  RunState read = run;
  read.seeded.particles.resize(count);
  transfer_state(reader, read, packed);
  if (packed) {
    read.packed =
        empty_packed_stage(run.seeded.grid, run.seeded.laws, takes_long_steps(*run.settings));
    transfer_packs(reader, *read.packed);
  }
  const Particles& p = read.seeded.particles;
  bool fits = reader.at_end() && read.seeded.grid.top.size() == run.seeded.grid.top.size();
  for (const auto* array : read.seeded.particles.arrays()) {
    fits = fits &&
           array->size() == (p.count + Particles::lanes - 1) / Particles::lanes * Particles::lanes;
  }
  fits = fits && p.law.size() == p.x.size() && p.id.size() == p.x.size();
  if (!fits || (packed && !packs_fit(*read.packed, p))) return false;
  if (packed) {
    PackedStage& stage = *read.packed;
    find_taken(stage.packs);
    spread_all(stage);
    unpack(stage.packs, stage.grid, read.seeded.particles);
  }
  run = std::move(read);
  run.resumed = true;
  return true;
}

}  // namespace leda::solver
