#include "solver/section/validate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "tests/section/bank.hpp"

namespace leda {
namespace {

using Change = std::function<void(Section&, RunSettings&)>;

std::vector<Fault> faults_after(const Change& change) {
  Section section = test::bank();
  RunSettings settings;
  change(section, settings);
  return validate(section, settings);
}

std::multiset<std::string> pointers(const std::vector<Fault>& faults) {
  std::multiset<std::string> found;
  for (const Fault& f : faults) found.insert(f.pointer);
  return found;
}

std::string text(const std::vector<Fault>& faults) {
  std::string all;
  for (const Fault& f : faults) all += f.pointer + ": " + f.message + "\n";
  return all;
}

struct Case {
  const char* name;
  Change change;
  std::multiset<std::string> expected;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

class Validate : public testing::TestWithParam<Case> {};

TEST_P(Validate, NamesExactlyTheFaults) {
  const auto faults = faults_after(GetParam().change);
  EXPECT_EQ(pointers(faults), GetParam().expected) << text(faults);
}

Layer with_line(const char* material, Polyline bottom) {
  Layer l = test::layer(material);
  l.bottom = std::move(bottom);
  return l;
}

std::vector<SoilColumn> halves(const Section& s) {
  return {{0, 50, s.layers}, {50, 100, s.layers}};
}

const Case cases[] = {
    {"sound", [](Section&, RunSettings&) {}, {}},
    {"ground_empty", [](Section& s, RunSettings&) { s.ground.clear(); }, {"/ground"}},
    {"ground_one_point", [](Section& s, RunSettings&) { s.ground.resize(1); }, {"/ground"}},
    {"ground_from_right_to_left",
     [](Section& s, RunSettings&) { std::ranges::reverse(s.ground); },
     {"/ground"}},
    {"ground_goes_back_and_nan",
     [](Section& s, RunSettings&) {
       s.ground[1].x = -1;
       s.ground[3].z = NAN;
     },
     {"/ground/1/0", "/ground/3/1"}},
    {"base_above_ground", [](Section& s, RunSettings&) { s.base_m = 6; }, {"/base_m"}},
    {"base_infinite", [](Section& s, RunSettings&) { s.base_m = -double{INFINITY}; }, {"/base_m"}},
    {"no_layers", [](Section& s, RunSettings&) { s.layers.clear(); }, {"/layers"}},
    {"material_not_defined",
     [](Section& s, RunSettings&) { s.layers[1].material = "sand"; },
     {"/layers/1/material"}},
    {"two_bottoms", [](Section& s, RunSettings&) { s.layers[0].bottom_m = 18; }, {"/layers/0"}},
    {"no_bottom", [](Section& s, RunSettings&) { s.layers[0].thickness_m.reset(); }, {"/layers/0"}},
    {"last_has_bottom", [](Section& s, RunSettings&) { s.layers[2].bottom_m = 1; }, {"/layers/2"}},
    {"thickness_zero",
     [](Section& s, RunSettings&) { s.layers[0].thickness_m = 0; },
     {"/layers/0/thickness_m"}},
    {"thicknesses_cross",
     [](Section& s, RunSettings&) {
       s.layers[1].bottom_m.reset();
       s.layers[1].thickness_m = 1.5;
     },
     {"/layers/1/thickness_m"}},
    {"elevations_cross",
     [](Section& s, RunSettings&) {
       s.layers[0].thickness_m.reset();
       s.layers[0].bottom_m = 4;
     },
     {"/layers/1/bottom_m"}},
    {"lines_cross_between_their_points",
     [](Section& s, RunSettings&) {
       s.layers[0] = with_line("crust", {{0, 18}, {100, 3}});
       s.layers[1] = with_line("clay", {{0, 10}, {50, 12}, {100, 1}});
     },
     {"/layers/1/bottom"}},
    {"line_goes_back",
     [](Section& s, RunSettings&) {
       s.layers[0] = with_line("crust", {{5, 18}, {1, 3}, {7, 3}});
     },
     {"/layers/0/bottom/1/0"}},
    {"columns_sound", [](Section& s, RunSettings&) { s.columns = halves(s); }, {}},
    {"columns_overlap_at_the_border",
     [](Section& s, RunSettings&) {
       s.columns = halves(s);
       s.columns[1].from_m = 49;
     },
     {"/columns/1/from_m"}},
    {"columns_leave_gaps",
     [](Section& s, RunSettings&) {
       s.columns = halves(s);
       s.columns[0].from_m = 1;
       s.columns[1].from_m = 51;
       s.columns[1].to_m = 99;
     },
     {"/columns/0/from_m", "/columns/1/from_m", "/columns/1/to_m"}},
    {"column_turned_round",
     [](Section& s, RunSettings&) {
       s.columns = halves(s);
       s.columns[1].to_m = 20;
     },
     {"/columns/1/to_m", "/columns/1/to_m"}},
    {"column_without_soil",
     [](Section& s, RunSettings&) {
       s.columns = halves(s);
       s.columns[1].layers[1].material = "sand";
       s.columns[0].layers.clear();
     },
     {"/columns/0/layers", "/columns/1/layers/1/material"}},
    {"water_both",
     [](Section& s, RunSettings&) {
       s.water_table->line = {{0, 1}, {1, 1}};
     },
     {"/water_table"}},
    {"water_neither",
     [](Section& s, RunSettings&) { s.water_table->depth_m.reset(); },
     {"/water_table"}},
    {"water_above_ground",
     [](Section& s, RunSettings&) { s.water_table->depth_m = -1; },
     {"/water_table/depth_m"}},
    {"water_line_above_ground",
     [](Section& s, RunSettings&) {
       s.water_table = WaterTable{{}, {{0, 15}, {100, 6}}};
     },
     {"/water_table/line"}},
    {"crest_off_ground",
     [](Section& s, RunSettings&) {
       s.crest = Point{40, 25};
     },
     {"/crest_m/1"}},
    {"toe_outside",
     [](Section& s, RunSettings&) {
       s.toe = Point{140, 5};
     },
     {"/toe_m/0"}},
    {"crest_below_toe",
     [](Section& s, RunSettings&) {
       s.crest = Point{80, 5};
       s.toe = Point{20, 20};
     },
     {"/crest_m"}},
    {"no_bank",
     [](Section& s, RunSettings&) {
       s.ground = {{0, 10}, {100, 10}};
     },
     {"/ground"}},
    {"cut_higher_than_bank",
     [](Section&, RunSettings& r) { r.trigger = UndrainedTrigger{15}; },
     {"/trigger/then_toe_cut_m"}},
    {"cut_negative",
     [](Section&, RunSettings& r) { r.trigger = UndrainedTrigger{-1}; },
     {"/trigger/then_toe_cut_m"}},
    {"polygon_two_corners",
     [](Section&, RunSettings& r) {
       r.trigger = ExcavationTrigger{{{60, 0}, {70, 20}}};
     },
     {"/trigger/polygon"}},
    {"polygon_crosses",
     [](Section&, RunSettings& r) {
       r.trigger = ExcavationTrigger{{{60, 4}, {80, 20}, {80, 4}, {60, 20}}};
     },
     {"/trigger/polygon"}},
    {"polygon_in_the_air",
     [](Section&, RunSettings& r) {
       r.trigger = ExcavationTrigger{{{75, 6}, {80, 6}, {80, 10}}};
     },
     {"/trigger/polygon"}},
    {"polygon_beside_the_section",
     [](Section&, RunSettings& r) {
       r.trigger = ExcavationTrigger{{{105, 0}, {110, 0}, {110, 4}}};
     },
     {"/trigger/polygon"}},
    {"polygon_nan",
     [](Section&, RunSettings& r) {
       r.trigger = ExcavationTrigger{{{60, 0}, {NAN, 0}, {70, 20}}};
     },
     {"/trigger/polygon/1/0"}},
    {"polygon_sound_and_closed",
     [](Section&, RunSettings& r) {
       r.trigger = ExcavationTrigger{{{60, 5}, {70, 5}, {70, 20}, {60, 20}, {60, 5}}};
     },
     {}},
    {"cell_zero",
     [](Section&, RunSettings& r) { r.resolution.cell_m = 0; },
     {"/resolution/cell_m"}},
    {"cell_too_large",
     [](Section&, RunSettings& r) { r.resolution.cell_m = 30; },
     {"/resolution/cell_m", "/resolution/cell_m"}},  // for the length and for the height
    {"cell_too_small",
     [](Section&, RunSettings& r) { r.resolution.cell_m = 0.01; },
     {"/resolution/cell_m"}},
    {"particles_not_square",
     [](Section&, RunSettings& r) { r.resolution.particles_per_cell = 5; },
     {"/resolution/particles_per_cell"}},
    {"damping",
     [](Section&, RunSettings& r) {
       r.damping.initial = 1;
       r.damping.dynamic = -0.1;
     },
     {"/damping/initial", "/damping/dynamic"}},
    {"time_step_factor",
     [](Section&, RunSettings& r) { r.time_step_factor = 1.01; },
     {"/time_step_factor"}},
    {"long_steps_of_one_particle_a_cell",
     [](Section&, RunSettings& r) {
       r.time_step_factor = 0.7;
       r.resolution.particles_per_cell = 1;
     },
     {"/time_step_factor"}},
    {"longest_step_of_one_particle_a_cell",
     [](Section&, RunSettings& r) {
       r.time_step_factor = 0.65;
       r.resolution.particles_per_cell = 1;
     },
     {}},
    {"stop", [](Section&, RunSettings& r) { r.stop.max_time_s = 0; }, {"/stop/max_time_s"}},
    {"frames_negative",
     [](Section&, RunSettings& r) { r.output.frame_interval_s = -1; },
     {"/output/frame_interval_s"}},
    {"frames_too_many",
     [](Section&, RunSettings& r) { r.output.frame_interval_s = 1e-4; },
     {"/output/frame_interval_s"}},
    {"all_at_once",
     [](Section& s, RunSettings& r) {
       s.ground[2].z = NAN;
       s.layers[1].material = "sand";
       s.materials["clay"].poisson_ratio = 0.5;
       r.resolution.cell_m = -1;
       r.stop.max_time_s = NAN;
     },
     {"/ground/2/1", "/layers/1/material", "/materials/clay/poisson_ratio", "/resolution/cell_m",
      "/stop/max_time_s"}},
};

INSTANTIATE_TEST_SUITE_P(Sections, Validate, testing::ValuesIn(cases),
                         [](const auto& case_info) { return std::string(case_info.param.name); });

TEST(ValidateMessage, NamesTheValueAndWhatWouldBeRight) {
  const auto faults = faults_after([](Section& s, RunSettings&) { s.base_m = 6.5; });
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].message, "is 6.5 m, must lie below the lowest ground (5 m at x = 70 m)");
}

}  // namespace
}  // namespace leda
