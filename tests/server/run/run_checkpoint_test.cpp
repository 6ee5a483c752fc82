#include "server/run/run_checkpoint.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <vector>

#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

Frame frame(float first) {
  Frame f;
  f.time_s = first;
  for (auto* array : {&f.x, &f.z, &f.velocity_x, &f.velocity_z, &f.stress_xx, &f.stress_zz,
                      &f.stress_xz, &f.stress_yy, &f.plastic_strain, &f.strength, &f.volume}) {
    array->assign(3, first++);
  }
  f.material.assign(3, 1);
  return f;
}

std::vector<Frame> shown(RunCheckpoint& checkpoint) {
  std::vector<Frame> frames;
  checkpoint.go_on([&](const Frame& f) { frames.push_back(f); });
  return frames;
}

class RunCheckpointTest : public testing::Test {
 protected:
  RunCheckpoint checkpoint(const std::string& sha256 = "abc", const std::string& version = "1") {
    return {folder.path(), sha256, version};
  }

  /// Two frames, a checkpoint, and a frame after it.
  void leave_one() {
    RunCheckpoint run = checkpoint();
    run.begin();
    run.add(frame(1));
    run.add(frame(2));
    run.keep("the state\nin two lines", 2);
    run.add(frame(3));
  }

  void change(const char* name, const std::function<void(std::string&)>& edit) {
    std::ifstream in(folder.path() / name, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    edit(bytes);
    std::ofstream(folder.path() / name, std::ios::binary | std::ios::trunc) << bytes;
  }

  static void expect_refused(const RunCheckpoint::Left& left, const std::string& why) {
    EXPECT_TRUE(left.state.empty());
    EXPECT_EQ(left.frames, 0);
    EXPECT_NE(left.refused.find(why), std::string::npos) << left.refused;
  }

  tests::TemporaryFolder folder;
};

TEST_F(RunCheckpointTest, NothingIsNoFault) {
  const auto left = checkpoint().read();
  EXPECT_TRUE(left.state.empty());
  EXPECT_TRUE(left.refused.empty());
}

TEST_F(RunCheckpointTest, GivesTheStateAndTheFramesBeforeIt) {
  leave_one();
  RunCheckpoint again = checkpoint();
  const auto left = again.read();
  EXPECT_EQ(left.refused, "");
  EXPECT_EQ(left.state, "the state\nin two lines");
  EXPECT_EQ(left.frames, 2);
  const auto frames = shown(again);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[1].x, frame(2).x);
  EXPECT_EQ(frames[1].volume, frame(2).volume);
  EXPECT_EQ(frames[1].material, frame(2).material);

  again.add(frame(4));
  again.keep("later", 3);
  RunCheckpoint later = checkpoint();
  EXPECT_EQ(later.read().state, "later");
  const auto all = shown(later);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[2].x, frame(4).x);
}

TEST_F(RunCheckpointTest, ACheckpointBeforeTheFirstFrameIsSound) {
  RunCheckpoint run = checkpoint();
  run.begin();
  run.keep("state", 0);
  RunCheckpoint again = checkpoint();
  EXPECT_EQ(again.read().state, "state");
  EXPECT_TRUE(shown(again).empty());
  again.add(frame(1));
  again.keep("next", 1);
  EXPECT_EQ(checkpoint().read().frames, 1);
}

TEST_F(RunCheckpointTest, OfAnotherCaseOrVersionIsRefused) {
  leave_one();
  expect_refused(checkpoint("abd").read(), "another case");
  expect_refused(checkpoint("abc", "2").read(), "leda 1 wrote it, this is leda 2");
}

TEST_F(RunCheckpointTest, TornIsRefusedWhereverItWasCut) {
  leave_one();
  const auto size = fs::file_size(folder.path() / "checkpoint.bin");
  for (auto cut = size; cut-- > 0;) {
    fs::resize_file(folder.path() / "checkpoint.bin", cut);
    const auto left = checkpoint().read();
    EXPECT_TRUE(left.state.empty()) << cut;
    EXPECT_FALSE(left.refused.empty()) << cut;
  }
}

TEST_F(RunCheckpointTest, ChangedAnywhereIsRefused) {
  leave_one();
  for (const char* name : {"checkpoint.bin", "frames.bin"}) {
    const auto size = fs::file_size(folder.path() / name);
    for (std::size_t at = 0; at < size * 2 / 3; at += 7) {
      change(name, [at](std::string& bytes) { bytes[at] ^= 0x10; });
      EXPECT_FALSE(checkpoint().read().refused.empty()) << name << " at " << at;
      change(name, [at](std::string& bytes) { bytes[at] ^= 0x10; });
    }
  }
  EXPECT_EQ(checkpoint().read().refused, "");
}

TEST_F(RunCheckpointTest, FramesThatAreCutOffOrGoneAreRefused) {
  leave_one();
  fs::resize_file(folder.path() / "frames.bin", fs::file_size(folder.path() / "frames.bin") / 2);
  expect_refused(checkpoint().read(), "frames");
  fs::remove(folder.path() / "frames.bin");
  expect_refused(checkpoint().read(), "frames");
}

TEST_F(RunCheckpointTest, ANumberOfFramesThatIsNotItsOwnIsAMistake) {
  RunCheckpoint run = checkpoint();
  run.begin();
  EXPECT_THROW(run.keep("state", 1), std::logic_error);
}

TEST_F(RunCheckpointTest, IsHandedOverToAnotherTry) {
  fs::create_directories(folder.path() / "next");
  EXPECT_FALSE(hand_over_checkpoint(folder.path(), folder.path() / "next"));
  leave_one();
  EXPECT_TRUE(hand_over_checkpoint(folder.path(), folder.path() / "next"));
  EXPECT_EQ(checkpoint().read().frames, 2) << "the first stands until it is removed";
  remove_checkpoint(folder.path());
  EXPECT_TRUE(checkpoint().read().state.empty());
  EXPECT_EQ(RunCheckpoint(folder.path() / "next", "abc", "1").read().frames, 2);
}

}  // namespace
}  // namespace leda::server
