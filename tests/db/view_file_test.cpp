#include "db/view_file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>

#include "tests/db/frames.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using samples::frame;
using samples::ScratchFolder;

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Array {
  std::string type;
  std::size_t components = 0;
  std::string bytes;

  template <class Value>
  std::vector<Value> as() const {
    std::vector<Value> values(bytes.size() / sizeof(Value));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
};

/// A reader of its own: the arrays of a VTU by name, found through offsets and sizes alone.
std::map<std::string, Array> parse_vtu(const std::string& vtu, std::size_t& particles) {
  const std::string start = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t marker = vtu.find(start);
  EXPECT_NE(marker, std::string::npos);
  const std::string head = vtu.substr(0, marker);
  const std::size_t data = marker + start.size();
  std::smatch found;
  EXPECT_TRUE(std::regex_search(head, found, std::regex("NumberOfPoints=\"(\\d+)\"")));
  particles = std::stoul(found[1]);

  const std::regex array(
      "<DataArray type=\"(\\w+)\" Name=\"([^\"]+)\" NumberOfComponents=\"(\\d)\" "
      "format=\"appended\" offset=\"(\\d+)\"/>");
  std::map<std::string, Array> arrays;
  std::size_t expected_offset = 0;
  for (std::sregex_iterator at(head.begin(), head.end(), array), end; at != end; ++at) {
    const std::size_t offset = std::stoul((*at)[4]);
    EXPECT_EQ(offset, expected_offset) << "blocks follow each other: " << (*at)[2];
    std::uint64_t size = 0;
    std::memcpy(&size, vtu.data() + data + offset, sizeof size);
    arrays[(*at)[2]] = {(*at)[1], std::stoul((*at)[3]),
                        vtu.substr(data + offset + sizeof size, size)};
    expected_offset = offset + sizeof size + size;
  }
  EXPECT_EQ(vtu.substr(data + expected_offset), "\n  </AppendedData>\n</VTKFile>\n");
  return arrays;
}

TEST(ViewFile, AFrameComesBackThroughItsOffsets) {
  const ScratchFolder folder;
  const Frame f = frame(2.5, 7);
  ViewWriter view(folder.path());
  view.append(f);
  view.close();

  std::size_t particles = 0;
  const auto arrays = parse_vtu(bytes_of(folder / "view/frame-0001.vtu"), particles);
  EXPECT_EQ(particles, 7U);
  EXPECT_EQ(arrays.at("connectivity").as<std::int64_t>(),
            (std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(arrays.at("offsets").as<std::int64_t>(),
            (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(arrays.at("types").as<std::uint8_t>(), std::vector<std::uint8_t>(7, 1));
  const auto points = arrays.at("Points").as<float>();
  const auto velocity = arrays.at("velocity (m/s)").as<float>();
  ASSERT_EQ(points.size(), 21U);
  ASSERT_EQ(velocity.size(), 21U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(points[3 * i], f.x[i]);
    EXPECT_EQ(points[3 * i + 1], f.z[i]);
    EXPECT_EQ(points[3 * i + 2], 0.0F);
    EXPECT_EQ(velocity[3 * i], f.velocity_x[i]);
    EXPECT_EQ(velocity[3 * i + 1], f.velocity_z[i]);
  }
  EXPECT_EQ(arrays.at("stress_xx (Pa)").as<float>(), f.stress_xx);
  EXPECT_EQ(arrays.at("stress_zz (Pa)").as<float>(), f.stress_zz);
  EXPECT_EQ(arrays.at("stress_xz (Pa)").as<float>(), f.stress_xz);
  EXPECT_EQ(arrays.at("stress_yy (Pa)").as<float>(), f.stress_yy);
  EXPECT_EQ(arrays.at("plastic_strain").as<float>(), f.plastic_strain);
  EXPECT_EQ(arrays.at("strength (Pa)").as<float>(), f.strength);
  EXPECT_EQ(arrays.at("volume (m3/m)").as<float>(), f.volume);
  EXPECT_EQ(arrays.at("material").as<std::int32_t>(), f.material);
  for (const auto& [name, array] : arrays) {
    const std::size_t width = array.type == "UInt8" ? 1 : array.type == "Int64" ? 8 : 4;
    EXPECT_EQ(array.bytes.size(), width * array.components * 7) << name;
  }
}

TEST(ViewFile, TheCollectionListsEveryFrameWithItsTime) {
  const ScratchFolder folder;
  ViewWriter view(folder.path());
  view.append(frame(0, 4));
  view.append(frame(0.1, 2));
  EXPECT_FALSE(std::filesystem::exists(folder / "view.pvd")) << "not before it is whole";
  view.close();
  const std::string pvd = bytes_of(folder / "view.pvd");
  EXPECT_NE(pvd.find("timestep=\"0\" part=\"0\" file=\"view/frame-0001.vtu\""), std::string::npos);
  EXPECT_NE(pvd.find("timestep=\"0.10000000000000001\" part=\"0\" file=\"view/frame-0002.vtu\""),
            std::string::npos)
      << pvd;
  std::size_t particles = 0;
  parse_vtu(bytes_of(folder / "view/frame-0002.vtu"), particles);
  EXPECT_EQ(particles, 2U);
}

TEST(ViewFile, AFrameWithoutParticlesIsStillAFile) {
  const ScratchFolder folder;
  ViewWriter view(folder.path());
  view.append(Frame{});
  std::size_t particles = 1;
  const auto arrays = parse_vtu(bytes_of(folder / "view/frame-0001.vtu"), particles);
  EXPECT_EQ(particles, 0U);
  EXPECT_TRUE(arrays.at("Points").bytes.empty());
}

TEST(ViewFile, NoPartsAreLeftBehind) {
  const ScratchFolder folder;
  ViewWriter view(folder.path());
  view.append(frame(0, 3));
  view.close();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST(ViewFile, ArraysOfUnequalLengthAreRefused) {
  const ScratchFolder folder;
  ViewWriter view(folder.path());
  Frame odd = frame(0, 3);
  odd.z.pop_back();
  EXPECT_THROW(view.append(odd), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "view/frame-0001.vtu"));
}

}  // namespace
}  // namespace leda::db
