#pragma once
// A dispatcher over a store of its own, whose runs end as a test says.

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "server/jobs/dispatcher.hpp"
#include "tests/server/run_fixture.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {

/// Ends every run at once, as it is told to; keeps those it is told to keep.
class ScriptedExecutor final : public Executor {
 public:
  using Script = std::function<std::optional<RunEnd>(const RunOrder&)>;
  /// @param cluster its runs outlive it, and are adopted
  explicit ScriptedExecutor(Script script, bool cluster = false)
      : script_(std::move(script)), cluster_(cluster) {}

  std::size_t free_slots() const override { return 2 - std::min<std::size_t>(2, kept_.size()); }
  void submit(const RunOrder& order) override {
    if (auto end = script_(order)) {
      ended_.push_back(*end);
    } else {
      kept_.push_back(order.run);
    }
  }
  std::vector<RunEnd> poll() override { return std::exchange(ended_, {}); }
  void cancel(const std::string& run) override {
    if (std::erase(kept_, run) > 0) ended_.push_back({run, RunEnd::How::cancelled, 0, "cancelled"});
  }
  bool outlives_server() const override { return cluster_; }
  bool adopt(const RunOrder& order) override {
    if (cluster_) submit(order);
    return cluster_;
  }

 private:
  Script script_;
  bool cluster_;
  std::vector<RunEnd> ended_;
  std::vector<std::string> kept_;
};

inline RunEnd exited(const RunOrder& order, int code) {
  return {order.run, RunEnd::How::exited, code, ""};
}
inline RunEnd killed(const RunOrder& order) {
  return {order.run, RunEnd::How::killed, 0, "the worker died of signal 9"};
}

class DispatcherTest : public testing::Test {
 protected:
  /// One section, as simulate-section asks for it.
  std::string add_job(const std::string& id = "job") {
    db::JobRecord job;
    job.id = id;
    job.process = "simulate-section";
    job.request = tests::simulate_request();
    store.add_job(job);
    return id;
  }

  std::unique_ptr<Dispatcher> dispatcher(const ScriptedExecutor::Script& script,
                                         bool cluster = false) {
    auto made = std::make_unique<Dispatcher>(data, store, [script, cluster, this] {
      const auto counted = [script, this](const RunOrder& order) {
        ++submitted;
        return script(order);
      };
      return std::make_unique<ScriptedExecutor>(counted, cluster);
    });
    made->start();
    return made;
  }

  db::JobRecord wait_for_end(const std::string& id = "job") {
    return wait([&](const db::JobRecord& job) { return !job.finished.empty(); }, id);
  }

  db::JobRecord wait(const std::function<bool(const db::JobRecord&)>& until,
                     const std::string& id = "job") {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    for (;;) {
      auto job = store.job(id).value();
      if (until(job) || std::chrono::steady_clock::now() > end) return job;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  db::SectionRecord section(const std::string& job = "job") { return store.sections(job).at(0); }

  tests::TemporaryFolder folder;
  DataFolder data{folder.path()};
  db::Store store{data.store(), std::chrono::milliseconds(50)};
  std::atomic<int> submitted{0};
};

inline std::optional<RunEnd> with_result(const RunOrder& order) {
  tests::leave_result(order.folder, tests::result_of_case_in(order.folder));
  return exited(order, 0);
}

}  // namespace leda::server
