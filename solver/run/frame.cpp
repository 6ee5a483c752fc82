#include <array>

#include "solver/run/observe.hpp"

namespace leda::solver {

namespace {

// What a frame shows as a pack or its motion holds it.
template <class Real>
struct Shown {
  Real (Pack<Real>::*lane)[Pack<Real>::lanes];
  std::vector<float> Frame::*values;
};

template <class Real>
constexpr std::array<Shown<Real>, 6> shown = {{
    {&Pack<Real>::sxx, &Frame::stress_xx},
    {&Pack<Real>::szz, &Frame::stress_zz},
    {&Pack<Real>::sxz, &Frame::stress_xz},
    {&Pack<Real>::syy, &Frame::stress_yy},
    {&Pack<Real>::plastic_strain, &Frame::plastic_strain},
    {&Pack<Real>::volume, &Frame::volume},
}};

double strength_now(const LawTable& laws, std::size_t row, double plastic_strain) {
  const bool soft = laws.softens[row] != 0 && plastic_strain > 0;
  return soft ? strength(laws.curve(row), plastic_strain) : laws.peak[row];
}

// Place of every id in the frame: ids in their order, without those cut away.
template <class Real>
std::vector<std::size_t> places(const Packs<Real>& packs, std::size_t ids) {
  std::vector<std::size_t> place(ids, 0);
  for_each_point(packs, [&](std::size_t i, std::size_t l) {
    place[static_cast<std::size_t>(packs.pack[i].id[l])] = 1;
  });
  std::size_t next = 0;
  for (std::size_t& one : place) {
    const std::size_t there = one;
    one = next;
    next += there;
  }
  return place;
}

template <class Real>
void fill(Frame& f, const Model<Real>& model, const Seeded& seeded) {
  const auto place = places(model.packs, seeded.start_x.size());
  for (const FrameField& field : frame_fields) (f.*field.values).resize(model.packs.count);
  f.material.resize(model.packs.count);
  for_each_point(model.packs, [&](std::size_t i, std::size_t l) {
    const auto& pack = model.packs.pack[i];
    const std::size_t to = place[static_cast<std::size_t>(pack.id[l])];
    const auto row = static_cast<std::size_t>(pack.law[l]);
    const PointAt at = point_at(model.packs, i, l, model.grid.h);
    f.x[to] = static_cast<float>(at.x + seeded.origin_x);
    f.z[to] = static_cast<float>(at.z + seeded.origin_z);
    if (model.packs.moves) {
      f.velocity_x[to] = static_cast<float>(model.packs.motion[i].vx[l]);
      f.velocity_z[to] = static_cast<float>(model.packs.motion[i].vz[l]);
    }
    for (const auto& number : shown<Real>) {
      (f.*number.values)[to] = static_cast<float>((pack.*number.lane)[l]);
    }
    f.strength[to] = static_cast<float>(strength_now(seeded.laws, row, pack.plastic_strain[l]));
    f.material[to] = seeded.laws.material[row];
  });
}

}  // namespace

Frame frame(const AnyModel& model, const Seeded& seeded, double time_s) {
  Frame f;
  f.time_s = time_s;
  with_model(model, [&](const auto& m) { fill(f, m, seeded); });
  return f;
}

}  // namespace leda::solver
