#include "server/jobs/take_in.hpp"

#include <gtest/gtest.h>

#include "db/result_file.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

class TakeInTest : public testing::Test {
 protected:
  TakeInTest() { tests::write_text(folder.path() / "case.json", tests::small_case()); }
  tests::TemporaryFolder folder;
};

TEST_F(TakeInTest, AWholeResultOfThisCaseCounts) {
  tests::leave_result(folder.path(), tests::result_of_case_in(folder.path()));
  const Outcome outcome = read_outcome(folder.path());
  ASSERT_TRUE(outcome.result) << outcome.fault;
  EXPECT_DOUBLE_EQ(outcome.result->crest_to_crest_retrogression_m, 12.5);
  EXPECT_EQ(outcome.document, tests::read_text(folder.path() / "result.json"));
}

TEST_F(TakeInTest, NothingElseCounts) {
  EXPECT_EQ(read_outcome(folder.path()).fault, "the run left no result");

  auto result = tests::result_of_case_in(folder.path());
  result.case_sha256 = std::string(64, '0');
  tests::leave_result(folder.path(), result);
  EXPECT_EQ(read_outcome(folder.path()).fault, "result.json is of another case");

  tests::leave_result(folder.path(), tests::result_of_case_in(folder.path()));
  std::filesystem::remove(folder.path() / "fields.h5");
  EXPECT_EQ(read_outcome(folder.path()).fault, "fields.h5 is missing");

  tests::leave_result(folder.path(), tests::result_of_case_in(folder.path()));
  const auto fields = folder.path() / "fields.h5";
  std::filesystem::resize_file(fields, std::filesystem::file_size(fields) / 2);
  EXPECT_EQ(read_outcome(folder.path()).fault, "fields.h5 is cut off or damaged");

  std::filesystem::remove(fields);
  db::ResultFileWriter(fields, {"clay"}, std::string(64, '0'), "test").close();
  EXPECT_EQ(read_outcome(folder.path()).fault, "fields.h5 is of another case");

  tests::write_text(folder.path() / "result.json", R"({"status": "at-rest")");
  const Outcome cut_off = read_outcome(folder.path());
  EXPECT_FALSE(cut_off.result);
  EXPECT_TRUE(cut_off.fault.starts_with("result.json: ")) << cut_off.fault;
}

TEST_F(TakeInTest, ProgressIsReadWhereItIsWhole) {
  EXPECT_EQ(read_fraction(folder.path()), 0);
  tests::write_text(folder.path() / "progress.json", R"({"fraction": 0.25, "stage": "softening"})");
  EXPECT_DOUBLE_EQ(read_fraction(folder.path()), 0.25);
  tests::write_text(folder.path() / "progress.json", R"({"fraction": 7})");
  EXPECT_DOUBLE_EQ(read_fraction(folder.path()), 1);
  tests::write_text(folder.path() / "progress.json", "{");
  EXPECT_EQ(read_fraction(folder.path()), 0);
}

TEST_F(TakeInTest, TheLastWordsAreTheLastLineThatSaysSomething) {
  EXPECT_EQ(last_words(folder.path()), "");
  tests::write_text(folder.path() / "log.txt", "first\nbad\x1b[31m alloc\n  \n\n");
  EXPECT_EQ(last_words(folder.path()), "bad [31m alloc");
}

}  // namespace
}  // namespace leda::server
