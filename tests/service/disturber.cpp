#include "tests/service/disturber.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/server/held_store.hpp"

namespace leda::tests {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr int most_failures = 2;

void damage(const fs::path& run, int how) {
  if (how == 0) {
    std::ofstream(run / "result.json", std::ios::binary | std::ios::trunc) << "{\"status\": \"at-";
  } else if (how == 1) {
    fs::resize_file(run / "fields.h5", fs::file_size(run / "fields.h5") / 2);
  } else {
    fs::remove(run / "fields.h5");
  }
}

}  // namespace

void Disturber::restart() {
  failures_.clear();
  server_.reset();
  server_ = start_();
}

/// "JOB-ORDINAL" of the run "JOB-ORDINAL-TRY"; empty where the worker is gone.
std::string Disturber::section_of(pid_t worker) {
  const std::string run = run_folder_of(worker).filename().string();
  return run.substr(0, run.rfind('-'));
}

bool Disturber::may_fail(const std::string& section) {
  return !section.empty() && failures_[section] < most_failures;
}

void Disturber::kill_server() {
  server_->kill_hard();
  ++done_.server_kills;
  restart();
}

void Disturber::kill_worker() {
  const auto workers = server_->workers();
  if (workers.empty()) return;
  const pid_t worker = workers[static_cast<std::size_t>(number(0, int(workers.size()) - 1))];
  const std::string section = section_of(worker);
  if (!may_fail(section)) return;
  ++failures_[section];
  kill(worker, SIGKILL);
  ++done_.worker_kills;
}

void Disturber::kill_any() { number(0, 99) < 55 ? kill_server() : kill_worker(); }

void Disturber::fill_disk() {
  auto processes = server_->workers();
  processes.push_back(server_->process());
  disk_.is_mounted() ? disk_.fill() : limit_file_size(processes, true);
  std::this_thread::sleep_for(std::chrono::milliseconds(number(500, 3000)));
  // Workers started meanwhile have the limit too.
  processes = server_->workers();
  processes.push_back(server_->process());
  disk_.is_mounted() ? disk_.free() : limit_file_size(processes, false);
  ++done_.full_disks;
}

void Disturber::corrupt_result() {
  const auto workers = server_->workers();
  if (workers.empty()) return;
  const pid_t worker = workers.front();
  const fs::path run = run_folder_of(worker);
  const std::string section = section_of(worker);
  if (!may_fail(section)) return;
  kill(server_->process(), SIGSTOP);
  const auto until = std::chrono::steady_clock::now() + 60s;
  const auto in_time = [&] { return std::chrono::steady_clock::now() < until; };
  while (state_of(server_->process()) != 'T' && in_time()) std::this_thread::sleep_for(1ms);
  // A worker that the stopped server has not yet buried, alive or dead, was not taken in.
  while (state_of(worker) != 'Z' && state_of(worker) != 0 && in_time()) {
    std::this_thread::sleep_for(10ms);
  }
  if (state_of(worker) == 'Z' && fs::exists(run / "result.json")) {
    damage(run, number(0, 2));
    ++failures_[section];
    ++done_.corrupt_results;
  }
  kill(server_->process(), SIGCONT);
}

void Disturber::hold_store() {
  const HeldStore other_program(disk_.folder() / "leda.sqlite");
  std::this_thread::sleep_for(12s);
  ++done_.held_stores;
}

void Disturber::wait() { std::this_thread::sleep_for(std::chrono::milliseconds(number(20, 700))); }

}  // namespace leda::tests
