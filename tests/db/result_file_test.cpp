#include "db/result_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "solver/section/frame.hpp"
#include "tests/db/frames.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using samples::frame;
using samples::ScratchFolder;

void write(const std::filesystem::path& file, const std::vector<Frame>& frames) {
  ResultFileWriter writer(file, {"crust", "S1", "argile sensible é"}, std::string(64, 'c'),
                          "0.1.0");
  for (const Frame& f : frames) writer.append(f);
  writer.close();
}

void expect_equal(const Frame& back, const Frame& f) {
  EXPECT_EQ(back.time_s, f.time_s);
  for (const FrameField& field : frame_fields)
    EXPECT_EQ(back.*field.values, f.*field.values) << field.name;
  EXPECT_EQ(back.material, f.material);
}

std::string fault_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ResultFile, FramesComeBackWhole) {
  const ScratchFolder folder;
  const std::vector<Frame> frames = {frame(0, 50), frame(0.5, 50), frame(1.25, 50)};
  write(folder / "fields.h5", frames);
  const auto back = read_result_file(folder / "fields.h5");
  ASSERT_EQ(back.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) expect_equal(back[i], frames[i]);
}

TEST(ResultFile, APartHasTheFramesAndFieldsThatWereAskedFor) {
  const ScratchFolder folder;
  const std::vector<Frame> frames = {frame(0, 50), frame(0.5, 60), frame(1.25, 40)};
  write(folder / "fields.h5", frames);
  const auto part = read_frames(folder / "fields.h5", {1, 2, 1000, {"x", "strength"}, true});
  EXPECT_EQ(part.times_s, (std::vector<double>{0, 0.5, 1.25}));
  EXPECT_EQ(part.materials.size(), 3U);
  ASSERT_EQ(part.frames.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(part.frames[i].time_s, frames[i + 1].time_s);
    EXPECT_EQ(part.frames[i].x, frames[i + 1].x);
    EXPECT_EQ(part.frames[i].strength, frames[i + 1].strength);
    EXPECT_EQ(part.frames[i].material, frames[i + 1].material);
    EXPECT_TRUE(part.frames[i].z.empty());
  }
}

TEST(ResultFile, APartEndsAtTheMostParticlesAndAtTheEndOfTheFile) {
  const ScratchFolder folder;
  write(folder / "fields.h5", {frame(0, 50), frame(1, 50), frame(2, 50)});
  const auto frames_of = [&](std::size_t first, std::size_t count, std::size_t most) {
    return read_frames(folder / "fields.h5", {first, count, most, {"x"}, false}).frames.size();
  };
  EXPECT_EQ(frames_of(0, 3, 100), 2U);
  EXPECT_EQ(frames_of(0, 3, 10), 1U) << "one, however large";
  EXPECT_EQ(frames_of(2, 3, 1000), 1U);
  EXPECT_EQ(frames_of(3, 3, 1000), 0U);
}

TEST(ResultFile, TheSameFramesGiveTheSameBytesAtAnotherTime) {
  const ScratchFolder folder;
  const std::vector<Frame> frames = {frame(0, 50), frame(0.5, 50)};
  write(folder / "early.h5", frames);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 counts seconds
  write(folder / "late.h5", frames);
  EXPECT_TRUE(bytes_of(folder / "early.h5") == bytes_of(folder / "late.h5"));
}

TEST(ResultFile, ParticlesMayBecomeFewerMoreOrNone) {
  const ScratchFolder folder;
  const std::vector<Frame> frames = {frame(0, 50), frame(1, 20), frame(2, 0), frame(3, 80)};
  write(folder / "fields.h5", frames);
  const auto back = read_result_file(folder / "fields.h5");
  ASSERT_EQ(back.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) expect_equal(back[i], frames[i]);
}

TEST(ResultFile, MoreParticlesThanAChunkHolds) {
  const ScratchFolder folder;
  const Frame large = frame(0, 70'001);
  write(folder / "fields.h5", {large});
  expect_equal(read_result_file(folder / "fields.h5").at(0), large);
}

TEST(ResultFile, ARunWithoutFramesIsAFileWithoutFrames) {
  const ScratchFolder folder;
  write(folder / "fields.h5", {});
  EXPECT_TRUE(read_result_file(folder / "fields.h5").empty());
}

TEST(ResultFile, ItSaysWhatMadeIt) {
  const ScratchFolder folder;
  write(folder / "fields.h5", {frame(0, 3)});
  const auto origin = read_result_file_origin(folder / "fields.h5");
  EXPECT_EQ(origin.materials, (std::vector<std::string>{"crust", "S1", "argile sensible é"}));
  EXPECT_EQ(origin.case_sha256, std::string(64, 'c'));
  EXPECT_EQ(origin.version, "0.1.0");
}

TEST(ResultFile, TheSameFramesGiveTheSameBytes) {
  const ScratchFolder folder;
  const std::vector<Frame> frames = {frame(0, 500), frame(1, 400)};
  write(folder / "a.h5", frames);
  write(folder / "b.h5", frames);
  EXPECT_EQ(bytes_of(folder / "a.h5"), bytes_of(folder / "b.h5"));
}

TEST(ResultFile, AFileThatIsNotClosedDoesNotStand) {
  const ScratchFolder folder;
  write(folder / "fields.h5", {frame(7, 3)});
  {
    ResultFileWriter writer(folder / "fields.h5", {}, "", "");
    writer.append(frame(0, 3));
  }
  EXPECT_EQ(read_result_file(folder / "fields.h5").at(0).time_s, 7) << "the old one stands";
  EXPECT_FALSE(std::filesystem::exists(folder / "fields.h5.part"));
}

TEST(ResultFile, WhatAKilledRunLeftIsOverwritten) {
  const ScratchFolder folder;
  std::ofstream(folder / "fields.h5.part") << "half a file";
  write(folder / "fields.h5", {frame(1, 3)});
  EXPECT_EQ(read_result_file(folder / "fields.h5").size(), 1U);
}

TEST(ResultFile, ArraysOfUnequalLengthAreRefusedAndHarmNothing) {
  const ScratchFolder folder;
  ResultFileWriter writer(folder / "fields.h5", {}, "", "");
  Frame odd = frame(0, 3);
  odd.strength.pop_back();
  EXPECT_THROW(writer.append(odd), std::invalid_argument);
  odd = frame(0, 3);
  odd.material.push_back(0);
  EXPECT_THROW(writer.append(odd), std::invalid_argument);
  writer.append(frame(1, 3));
  writer.close();
  EXPECT_EQ(read_result_file(folder / "fields.h5").size(), 1U);
}

TEST(ResultFile, AFolderThatDoesNotStandIsNamed) {
  const ScratchFolder folder;
  const std::string fault =
      fault_of([&] { ResultFileWriter(folder / "nowhere/fields.h5", {}, "", ""); });
  EXPECT_NE(fault.find("nowhere/fields.h5"), std::string::npos) << fault;
}

TEST(ResultFile, AMissingFileIsNamed) {
  const ScratchFolder folder;
  const std::string fault = fault_of([&] { read_result_file(folder / "none.h5"); });
  EXPECT_NE(fault.find("none.h5: no such file"), std::string::npos) << fault;
}

TEST(ResultFile, ATruncatedFileIsAClearError) {
  const ScratchFolder folder;
  write(folder / "fields.h5", {frame(0, 500), frame(1, 500)});
  const std::string whole = bytes_of(folder / "fields.h5");
  for (const std::size_t length :
       {whole.size() - 1, whole.size() / 2, std::size_t{100}, std::size_t{3}, std::size_t{0}}) {
    std::ofstream(folder / "cut.h5", std::ios::binary | std::ios::trunc) << whole.substr(0, length);
    const std::string fault = fault_of([&] { read_result_file(folder / "cut.h5"); });
    EXPECT_NE(fault.find("cut.h5"), std::string::npos) << length << " bytes: " << fault;
    EXPECT_NE(fault.find("truncated"), std::string::npos) << length << " bytes: " << fault;
  }
}

TEST(ResultFile, DamagedBytesAreNeverReadAsNumbers) {
  const ScratchFolder folder;
  const std::vector<Frame> frames = {frame(0, 2000)};
  write(folder / "fields.h5", frames);
  const std::string whole = bytes_of(folder / "fields.h5");
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); at += 97) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    std::ofstream(folder / "bad.h5", std::ios::binary | std::ios::trunc) << damaged;
    std::vector<Frame> back;
    if (!fault_of([&] { back = read_result_file(folder / "bad.h5"); }).empty()) {
      ++refused;
      continue;
    }
    // A byte that nothing is read from: unused space, or an attribute's own text.
    ASSERT_EQ(back.size(), 1U) << "byte " << at;
    expect_equal(back[0], frames[0]);
  }
  EXPECT_GT(refused, 100);
}

TEST(ResultFile, AnotherKindOfHdf5FileIsRefused) {
  const ScratchFolder folder;
  const std::string name = (folder / "other.h5").string();
  H5Fclose(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  const std::string fault = fault_of([&] { read_result_file(name); });
  EXPECT_NE(fault.find("attribute format"), std::string::npos) << fault;
}

TEST(ResultFile, CountsBeyondTheRowsAreRefused) {
  const ScratchFolder folder;
  write(folder / "fields.h5", {frame(0, 5)});
  const std::string name = (folder / "fields.h5").string();
  const hid_t file = H5Fopen(name.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t counts = H5Dopen2(file, "particles", H5P_DEFAULT);
  const std::int64_t huge = 1'000'000'000'000;
  H5Dwrite(counts, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &huge);
  H5Dclose(counts);
  H5Fclose(file);
  const std::string fault = fault_of([&] { read_result_file(name); });
  EXPECT_NE(fault.find("1000000000000 particles of frame 0"), std::string::npos) << fault;
}

}  // namespace
}  // namespace leda::db
