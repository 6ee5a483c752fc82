// leda dss, calibrate and fit from the command line: exit codes, output, refusals.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace leda {
namespace {

using nlohmann::json;

struct Said {
  int code;
  std::string out;  ///< standard output and error
};

class Commands : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("leda-element-" + std::to_string(getpid()) + "-" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    write("case.json", R"({
      "name": "bank", "ground": [[0, 20], [60, 20], [80, 8], [120, 8]], "base_m": 0,
      "layers": [{"material": "crust", "thickness_m": 2}, {"material": "clay", "bottom_m": 4},
                 {"material": "deep"}],
      "materials": {
        "crust": {"unit_weight_kN_m3": 18, "youngs_modulus_kPa": 10000, "poisson_ratio": 0.45,
                  "peak_strength_kPa": 90},
        "clay": {"unit_weight_kN_m3": 16, "shear_modulus_kPa": 4050, "poisson_ratio": 0.45,
                 "peak_strength_kPa": 40.5,
                 "softening": {"law": "urmi", "alpha": 0.95, "beta": 2.8, "residual_strain": 1.8,
                               "remolded_strength_kPa": 0.736}},
        "deep": {"unit_weight_kN_m3": 16, "shear_modulus_kPa": 4050, "poisson_ratio": 0.45,
                 "peak_strength_kPa": {"at_depth_m": [[10, 25], [20, 50]]}}},
      "trigger": {"kind": "undrained"}, "resolution": {"cell_m": 1, "particles_per_cell": 4}})");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  Said leda(const std::string& arguments) const {
    const std::string line = "cd '" + folder_.string() + "' && " + LEDA_BINARY + " " + arguments;
    FILE* pipe = popen(("( " + line + " ) 2>&1").c_str(), "r");
    Said said{-1, {}};
    std::array<char, 4096> part{};
    while (std::size_t n = fread(part.data(), 1, part.size(), pipe))
      said.out.append(part.data(), n);
    said.code = WEXITSTATUS(pclose(pipe));
    return said;
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(Commands, DssWritesTheCurveAsCsv) {
  const Said said = leda("dss case.json --material clay");
  EXPECT_EQ(said.code, 0);
  EXPECT_TRUE(said.out.starts_with(
      "shear_strain,displacement_m,shear_stress_kPa,plastic_strain\n0,0,0,0\n"));
  EXPECT_NE(said.out.find("\n0.01,0.00014,40.5,0\n"), std::string::npos);
}

TEST_F(Commands, DssInACellAsJsonAndDrawing) {
  const Said said =
      leda("dss case.json --material clay --cell 0.5 --json --svg d.svg --out d.json");
  EXPECT_EQ(said.code, 0) << said.out;
  const Said shown = leda("--version && cat d.json");
  const json curve = json::parse(shown.out.substr(shown.out.find('{')));
  EXPECT_EQ(curve["cell_m"], 0.5);
  EXPECT_EQ(curve["snaps_back"], false);
  EXPECT_EQ(curve["shear_strain"].size(), curve["shear_stress_kPa"].size());
  EXPECT_EQ(leda("--version && grep -c '</svg>' d.svg").code, 0);
}

TEST_F(Commands, DssOfParticlesIsTheSolversOwn) {
  const std::string shear = "dss case.json --material clay --max-strain 0.3 --json";
  const json law = json::parse(leda(shear).out);
  const Said said = leda(shear + " --method particles --particles-per-cell 9 --svg both.svg");
  ASSERT_EQ(said.code, 0) << said.out;
  const json solver = json::parse(said.out);
  EXPECT_EQ(solver["method"], "particles");
  EXPECT_NEAR(solver["work_kN_m"], law["work_kN_m"], 0.01 * law["work_kN_m"].get<double>());
}

TEST_F(Commands, DssRefusesWhatTheMethodWouldIgnore) {
  EXPECT_EQ(leda("dss case.json --material clay --vertical-stress-kPa 93").code, 2);
  EXPECT_EQ(leda("dss case.json --material clay --particles-per-cell 9").code, 2);
  const std::string particles = "dss case.json --material clay --method particles ";
  EXPECT_EQ(leda(particles + "--vertical-stress-kPa 93 --max-strain 0.1").code, 0);
  const Said said = leda(particles + "--vertical-stress-kPa 400");
  EXPECT_EQ(said.code, 2);
  EXPECT_NE(said.out.find("100 kPa before the test"), std::string::npos);
  EXPECT_EQ(leda(particles + "--particles-per-cell 5").code, 2);
}

TEST_F(Commands, StrengthByDepthNeedsADepth) {
  EXPECT_EQ(leda("dss case.json --material deep").code, 2);
  const Said said = leda("dss case.json --material deep --depth 15 --json");
  EXPECT_EQ(said.code, 0);
  EXPECT_EQ(json::parse(said.out)["peak_strength_kPa"], 37.5);
  EXPECT_EQ(leda("dss case.json --material clay --depth 15").code, 2);
}

TEST_F(Commands, WhatIsNotThereIsNamed) {
  const Said material = leda("dss case.json --material peat");
  EXPECT_EQ(material.code, 2);
  EXPECT_NE(material.out.find("clay, crust, deep"), std::string::npos);
  EXPECT_EQ(leda("dss nowhere.json --material clay").code, 2);
  EXPECT_EQ(leda("dss case.json").code, 2);
  EXPECT_EQ(leda("calibrate case.json --material clay").code, 2);
  EXPECT_EQ(leda("calibrate case.json --material clay --cell -1").code, 2);
  EXPECT_EQ(leda("calibrate case.json --material crust --cell 1").code, 2);
}

TEST_F(Commands, ARateLawRaisesTheCurveWithTheRate) {
  const Said made = leda(
      "--version && sed 's/\"unit_weight_kN_m3\": 16/\"rate\": {\"law\": \"power\", "
      "\"exponent\": 0.1, \"reference_rate_per_s\": 1e-5}, &/' case.json > rate.json");
  ASSERT_EQ(made.code, 0) << made.out;
  const Said slow = leda("dss rate.json --material clay --rate-per-s 1e-5 --json");
  const Said fast = leda("dss rate.json --material clay --rate-per-s 1e-2 --json");
  ASSERT_EQ(slow.code, 0) << slow.out;
  ASSERT_EQ(fast.code, 0) << fast.out;
  const auto largest = [](const Said& said) {
    const json stress = json::parse(said.out).at("shear_stress_kPa");
    return std::ranges::max(stress.get<std::vector<double>>());
  };
  // Of what lies above the remolded strength.
  const double remolded = 0.736;
  EXPECT_NEAR((largest(fast) - remolded) / (largest(slow) - remolded), std::pow(1000.0, 0.1),
              0.001);
  EXPECT_EQ(leda("dss case.json --material clay --rate-per-s 1").code, 2);
}

TEST_F(Commands, CalibrateGivesBothScalingsTwice) {
  const Said said = leda("calibrate case.json --material clay --cell 0.5 --json");
  ASSERT_EQ(said.code, 0) << said.out;
  const json out = json::parse(said.out);
  for (const char* name : {"beta", "whole-curve"}) {
    const json& one = out[name];
    EXPECT_NEAR(one["cell"]["decay_per_strain"], 100, 1e-9);  // 2.8 x 0.5 / 0.014
    EXPECT_NEAR(one["scale_numerical"].get<double>() / one["scale_closed_form"].get<double>(), 1,
                1e-9);
  }
  EXPECT_NEAR(out["beta"]["cell"]["remolded_strain"], 9.477, 1e-9);
  EXPECT_NEAR(out["whole-curve"]["cell"]["remolded_strain"], 9.477 * 0.014 / 0.5, 1e-9);
  EXPECT_NE(leda("calibrate case.json --material clay --cell 2").out.find("snaps back"),
            std::string::npos);
}

TEST_F(Commands, OddMagnitudesAreTold) {
  ASSERT_EQ(leda("--version && sed 's/\"beta\": 2.8/\"beta\": 0.028/' case.json > odd.json").code,
            0);
  for (const std::string command : {"dss", "calibrate --cell 0.5"}) {
    const std::string line = command + " odd.json --material clay ";
    EXPECT_NE(leda(line).out.find("warning: material clay: softening/beta is 0.028"),
              std::string::npos)
        << command;
    const json document = json::parse(leda(line + "--json 2>/dev/null").out);
    EXPECT_NE(document["warnings"].dump().find("not per percent"), std::string::npos) << command;
  }
  EXPECT_TRUE(json::parse(leda("dss case.json --material clay --json").out)["warnings"].empty());
}

TEST_F(Commands, FitTellsOddMagnitudes) {
  write("in_Pa.csv",
        "shear_strain,shear_stress_kPa\n0,0\n0.01,40000\n0.1,35000\n0.2,28000\n0.3,22000\n"
        "0.5,13000\n0.8,6000\n1.2,3000\n");
  const std::string line = "fit in_Pa.csv --remolded-strength-kPa 1 ";
  EXPECT_NE(leda(line).out.find("is it Pa given for kPa?"), std::string::npos) << leda(line).out;
  const json document = json::parse(leda(line + "--json 2>/dev/null").out);
  EXPECT_NE(document["warnings"].dump().find("is rock"), std::string::npos);
}

TEST_F(Commands, ScreenTellsOddMagnitudesInItsAnswerToo) {
  const json of_case = json::parse(leda("screen case.json --json 2>/dev/null").out);
  EXPECT_TRUE(of_case["warnings"].is_array());
  ASSERT_EQ(leda("--version && sed 's/\"beta\": 2.8/\"beta\": 0.028/' case.json > odd.json").code,
            0);
  const json of_odd = json::parse(leda("screen odd.json --json 2>/dev/null").out);
  EXPECT_NE(of_odd["warnings"].dump().find("not per percent"), std::string::npos);
  write("site.json", R"({"height_m": 15, "unit_weight_kN_m3": 9, "peak_strength_kPa": 40})");
  EXPECT_NE(leda("screen --site site.json").out.find("warning: material clay: unit_weight_kN_m3"),
            std::string::npos);
  const json of_site = json::parse(leda("screen --site site.json --json 2>/dev/null").out);
  EXPECT_NE(of_site["warnings"].dump().find("unit_weight_kN_m3 is 9"), std::string::npos);
}

TEST_F(Commands, FitFindsWhatWasSheared) {
  EXPECT_EQ(leda("dss case.json --material clay --max-strain 0.4 --out curve.csv").code, 0);
  const Said said = leda("fit curve.csv --remolded-strength-kPa 0.736 --json 2>/dev/null");
  ASSERT_EQ(said.code, 0);
  const json law = json::parse(said.out)["urmi"]["softening"];
  EXPECT_NEAR(law["alpha"], 0.95, 1e-4);
  EXPECT_NEAR(law["beta"], 2.8, 1e-3);
  EXPECT_NE(leda("fit curve.csv --remolded-strength-kPa 0.736").out.find("eq. 3-13"),
            std::string::npos);
}

TEST_F(Commands, FitWarnsOfAShortCurve) {
  EXPECT_EQ(leda("dss case.json --material clay --max-strain 0.1 --out curve.csv").code, 0);
  const Said said = leda("fit curve.csv --remolded-strength-kPa 0.736");
  EXPECT_EQ(said.code, 0);
  EXPECT_NE(said.out.find("below 30 %"), std::string::npos);
}

TEST_F(Commands, FitReadsEnergyCurvesAndAsksForWhatTheyLack) {
  write("energy.csv",
        "normalized_energy,remolding_index_percent\n2,10\n5,30\n10,50\n20,68\n40,82\n80,90\n");
  const Said lacking = leda("fit energy.csv --remolded-strength-kPa 1.3");
  EXPECT_EQ(lacking.code, 2);
  EXPECT_NE(lacking.out.find("--peak-strength-kPa"), std::string::npos);
  EXPECT_NE(lacking.out.find("--preconsolidation-kPa"), std::string::npos);
  const Said said = leda(
      "fit energy.csv --remolded-strength-kPa 1.3 --peak-strength-kPa 39 "
      "--preconsolidation-kPa 125 --json 2>/dev/null");
  ASSERT_EQ(said.code, 0) << said.out;
  EXPECT_NEAR(json::parse(said.out)["peak_strain"], 0.083333, 1e-5);  // Louiseville, eq. 3-5
}

TEST_F(Commands, FitRefusesABadFileWithItsLines) {
  write("bad.csv", "shear_strain,shear_stress_kPa\n0,0\nx,1\n");
  const Said said = leda("fit bad.csv --remolded-strength-kPa 1");
  EXPECT_EQ(said.code, 2);
  EXPECT_NE(said.out.find("line 3"), std::string::npos);
  write("empty.csv", "shear_strain,shear_stress_kPa\n");
  EXPECT_EQ(leda("fit empty.csv --remolded-strength-kPa 1").code, 2);
}

}  // namespace
}  // namespace leda
