// kill -9 at any moment: what was answered for is there, what was under way is not, and the file
// is sound.

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using samples::ScratchFolder;

constexpr int sections_a_job = 300;

/// A child process that says a byte at each step it has finished.
class Child {
 public:
  template <class Work>
  explicit Child(Work work) {
    EXPECT_EQ(::pipe(pipe_), 0);
    pid_ = ::fork();
    if (pid_ == 0) {
      work([this] { return ::write(pipe_[1], "x", 1) == 1; });
      ::_exit(0);
    }
    ::close(pipe_[1]);
  }
  ~Child() { ::close(pipe_[0]); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool hear() {
    char byte = 0;
    return ::read(pipe_[0], &byte, 1) == 1;
  }
  /// Kills it and counts what it still had said.
  int kill_and_hear_the_rest() {
    ::kill(pid_, SIGKILL);
    int status = 0;
    ::waitpid(pid_, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "the child ended before it was killed";
    int rest = 0;
    while (hear()) ++rest;
    return rest;
  }

 private:
  int pipe_[2] = {-1, -1};
  pid_t pid_ = -1;
};

std::string integrity(const std::filesystem::path& file) {
  SQLite::Database raw(file.string());
  return raw.execAndGet("PRAGMA integrity_check").getString();
}

TEST(Crash, KilledInTheMiddleOfATransactionLosesOnlyThatOne) {
  const ScratchFolder folder;
  const auto file = folder / "leda.sqlite";
  Child child([&](auto say) {
    Store store(file);
    store.add_job(samples::job("committed"));
    SQLite::Database raw(file.string(), SQLite::OPEN_READWRITE);
    raw.exec("PRAGMA cache_size = 1");  // spills into the write-ahead log before the commit
    raw.exec("BEGIN IMMEDIATE");
    raw.exec("UPDATE jobs SET name = 'half way' WHERE id = 'committed'");
    raw.exec(
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 5000) "
        "INSERT INTO jobs (id, process, name, state, message, progress, created, "
        "updated) SELECT 'never' || i, 'p', hex(zeroblob(200)), 'accepted', '', 0, '', '' "
        "FROM n");
    say();
    ::pause();
  });
  ASSERT_TRUE(child.hear());
  child.kill_and_hear_the_rest();

  Store store(file);
  EXPECT_EQ(store.count_jobs({}), 1);
  EXPECT_EQ(store.job("committed")->name, "sainte-monique");
  store.add_job(samples::job("afterwards"));
  EXPECT_EQ(store.count_jobs({}), 2);
  EXPECT_EQ(integrity(file), "ok");
}

TEST(Crash, KilledAtAnyMomentEveryAnswerHoldsAndEveryLayoutIsWhole) {
  for (int attempt = 0; attempt < 5; ++attempt) {
    const ScratchFolder folder;
    const auto file = folder / "leda.sqlite";
    Child child([&](auto say) {
      Store store(file);
      const auto sections = samples::layout(sections_a_job);
      for (int i = 0;; ++i) {
        const std::string id = samples::numbered("job-", i);
        store.add_job(samples::job(id));
        store.set_sections(id, sections);
        if (!say()) return;
      }
    });
    int answered = 0;
    for (; answered < 3; ++answered) ASSERT_TRUE(child.hear());
    ::usleep(static_cast<useconds_t>(attempt * 1700));  // another point of the work each time
    answered += child.kill_and_hear_the_rest();

    Store store(file);
    for (int i = 0; i < answered; ++i)
      EXPECT_EQ(store.sections(samples::numbered("job-", i)).size(),
                static_cast<std::size_t>(sections_a_job));
    for (const JobStatus& job : store.jobs({.limit = 100'000})) {
      const std::size_t count = store.sections(job.id).size();
      EXPECT_TRUE(count == 0 || count == sections_a_job) << job.id << " has " << count;
    }
    EXPECT_EQ(integrity(file), "ok");
  }
}

}  // namespace
}  // namespace leda::db
