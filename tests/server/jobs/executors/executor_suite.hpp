#pragma once
// What every executor is held to, whatever computes its runs: one suite, run over each of them.

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "server/jobs/executors/local_executor.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::tests {

/// How the suite makes an executor whose workers run `program`.
struct ExecutorKind {
  std::string name;
  /// @param state a folder that the executor may keep its notes in; outlives it
  std::function<std::unique_ptr<server::Executor>(const std::filesystem::path& program,
                                                  const server::RunLimits& limits,
                                                  const std::filesystem::path& state)>
      make;
  /// Why it can't be tested here; empty: it can.
  std::function<std::string()> missing = [] { return std::string(); };
  std::chrono::seconds patience{20};  ///< how long a short run may take to be told
  std::chrono::seconds shortest_wall{1};
};

class ExecutorSuite : public testing::TestWithParam<ExecutorKind> {
 protected:
  void SetUp() override;

  /// A script that is called as a worker is: simulate CASE --out FOLDER.
  std::filesystem::path program(const std::string& body);
  server::RunOrder order(const std::string& run);
  std::unique_ptr<server::Executor> executor(const std::filesystem::path& worker,
                                             const server::RunLimits& limits = {});
  static server::RunEnd wait_for_end(server::Executor& of);
  std::string text(const std::filesystem::path& file) const;
  /// Waits until a file of a run says something.
  bool wait_for_text(server::Executor& of, const std::filesystem::path& file);

  TemporaryFolder folder;
};

}  // namespace leda::tests
