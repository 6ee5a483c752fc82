// What Slurm's programs write, as Slurm 22.05 wrote it, and what Leda makes of it.

#include "server/jobs/executors/slurm/task_state.hpp"

#include <gtest/gtest.h>

namespace leda::server {
namespace {

TEST(TaskState, TheQueueIsReadByNameAndIndex) {
  const auto queue = read_queue(
      "1|2|PENDING|leda-x\n1|5|RUNNING|leda-x\n7|N/A|RUNNING|somebody's job\n12|0|COMPLETING|y\n"
      "no line of a queue\n");
  ASSERT_EQ(queue.size(), 3U);
  EXPECT_EQ(queue.at({"leda-x", 5}).state, "RUNNING");
  EXPECT_EQ(queue.at({"y", 0}).array_id, "12");
  for (const auto& [key, task] : queue) EXPECT_FALSE(task.is_over()) << task.state;
}

TEST(TaskState, RecordsOfControllerAndCompletionFileAreReadAlike) {
  const auto records = read_records(
      "JobId=6 ArrayJobId=1 ArrayTaskId=4 JobName=leda-x UserId=root(0) JobState=FAILED "
      "Reason=JobLaunchFailure ExitCode=0:24 RunTime=00:00:00\n"
      "JobId=1 ArrayJobId=1 ArrayTaskId=5 JobName=leda-x JobState=RUNNING ExitCode=0:0\n"
      "JobId=9 ArrayJobId=9 ArrayTaskId=3-9%2 JobName=leda-y JobState=PENDING ExitCode=0:0\n"
      "JobId=8 JobName=no-array JobState=COMPLETED ExitCode=0:0\n"
      "JobId=3 UserId=root(0) Name=leda-x JobState=NODE_FAIL ArrayJobId=1 ArrayTaskId=1 "
      "DerivedExitCode=0:0 ExitCode=0:0 \n"
      "JobId=3 UserId=root(0) Name=leda-x JobState=FAILED ArrayJobId=1 ArrayTaskId=1 "
      "DerivedExitCode=0:0 ExitCode=3:0 \n");
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(records.at({"leda-x", 4}).signal, 24);
  EXPECT_FALSE(records.at({"leda-x", 5}).is_over());
  EXPECT_EQ(records.at({"leda-x", 5}).array_id, "1");
  EXPECT_EQ(records.at({"leda-x", 1}).exit_code, 3) << "the last line counts";
}

struct End {
  TaskState task;
  bool asked;
  RunEnd::How how;
  std::string words;
  bool begun = true;
};

TEST(TaskState, EveryStateIsOneEnd) {
  using How = RunEnd::How;
  const std::vector<End> ends = {
      {{"1", "COMPLETED", 0, 0}, false, How::exited, ""},
      {{"1", "COMPLETED", 0, 0}, true, How::exited, ""},
      {{"1", "FAILED", 3, 0}, false, How::exited, "code 3"},
      {{"1", "FAILED", 0, 9}, false, How::killed, "signal 9"},
      {{"1", "FAILED", 0, 24}, false, How::over_limit, "processor time"},
      {{"1", "TIMEOUT", 0, 15}, false, How::over_limit, "longer"},
      {{"1", "DEADLINE", 0, 0}, false, How::over_limit, "longer"},
      {{"1", "TIMEOUT", 0, 15}, false, How::killed, "before the run had begun", false},
      {{"1", "DEADLINE", 0, 0}, false, How::killed, "before the run had begun", false},
      {{"1", "TIMEOUT", 0, 15}, true, How::cancelled, "cancelled", false},
      {{"1", "OUT_OF_MEMORY", 0, 125}, false, How::over_limit, "memory", false},
      {{"1", "OUT_OF_MEMORY", 0, 125}, false, How::over_limit, "memory"},
      {{"1", "CANCELLED", 0, 15}, true, How::cancelled, "cancelled"},
      {{"1", "CANCELLED", 0, 15}, false, How::killed, "cancelled in Slurm"},
      {{"1", "CANCELLED", 0, 0}, false, How::killed, "cancelled in Slurm", false},
      {{"1", "NODE_FAIL", 0, 0}, false, How::killed, "node"},
      {{"1", "BOOT_FAIL", 0, 0}, false, How::killed, "node", false},
      {{"1", "PREEMPTED", 0, 0}, false, How::killed, "room"}};
  for (const auto& [task, asked, how, words, begun] : ends) {
    EXPECT_TRUE(task.is_over());
    const RunEnd end = end_of("r", task, asked, begun);
    EXPECT_EQ(end.how, how) << task.state;
    EXPECT_NE(end.reason.find(words), std::string::npos) << end.reason;
    EXPECT_EQ(end.reason.empty(), words.empty()) << end.reason;
  }
}

TEST(TaskState, IndicesAreWrittenAsRanges) {
  EXPECT_EQ(array_range({0, 1, 2, 5, 7, 8}), "0-2,5,7-8");
  EXPECT_EQ(array_range({4}), "4");
  EXPECT_EQ(array_range({}), "");
}

}  // namespace
}  // namespace leda::server
