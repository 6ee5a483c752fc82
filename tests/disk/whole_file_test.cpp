#include "disk/whole_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <system_error>

#include "tests/server/temporary_folder.hpp"

namespace leda::disk {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(WholeFile, ReplacesAndLeavesNothingBesideIt) {
  const tests::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  write_whole(file, "first, longer");
  write_durably(file, "second");
  EXPECT_EQ(read(file), "second");
  append_to_file(file, ", ", "third");
  EXPECT_EQ(read(file), "second, third");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(WholeFile, WhatCannotBeWrittenIsNamedWithItsCause) {
  const tests::TemporaryFolder folder;
  using Write = void (*)(const fs::path&);
  for (const Write write : {Write([](const fs::path& f) { write_whole(f, "text"); }),
                            Write([](const fs::path& f) { write_durably(f, "te", "xt"); }),
                            Write([](const fs::path& f) { append_to_file(f, "text"); })}) {
    try {
      write(folder.path() / "missing" / "a.txt");
      FAIL() << "it was written";
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("missing/a.txt"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos);
      EXPECT_FALSE(tells_of_full_disk(error));
    }
  }
}

// In a child, because a limit on the size of files is the whole process's.
TEST(WholeFile, WhereThereIsNoSpaceTheFileBeforeStands) {
  const tests::TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  write_whole(file, "before");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    int code = 1;
    try {
      write_whole(file, std::string(2000, 'x'));
    } catch (const FileError& error) {
      code = tells_of_full_disk(error) ? 0 : 2;
    }
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_EQ(read(file), "before");
  EXPECT_FALSE(fs::exists(folder.path() / "a.txt.part"));
}

TEST(WholeFile, AFullDiskIsToldInManyWords) {
  for (const int code : {ENOSPC, EDQUOT}) {
    EXPECT_TRUE(tells_of_full_disk(std::system_error(code, std::generic_category(), "write")));
  }
  EXPECT_TRUE(tells_of_full_disk(std::runtime_error("leda.sqlite: database or disk is full")));
  EXPECT_FALSE(tells_of_full_disk(std::system_error(EIO, std::generic_category(), "write")));
}

}  // namespace
}  // namespace leda::disk
