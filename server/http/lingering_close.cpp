#include "server/http/lingering_close.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace leda::server {
namespace {

using namespace std::chrono_literals;

constexpr auto quiet = 500ms;  // a client that sent nothing for so long has read its answer
constexpr auto longest = 5s;   // whatever it sends
constexpr int between_looks_ms = 20;

}  // namespace

LingeringClose::LingeringClose(std::size_t most) : most_(most), thread_([this] { work(); }) {}

LingeringClose::~LingeringClose() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void LingeringClose::take(int socket) {
  ::shutdown(socket, SHUT_WR);
  {
    const std::lock_guard lock(mutex_);
    if (lingering_ < most_ && !ending_) {
      ++lingering_;
      const auto now = Clock::now();
      taken_.push_back({socket, now, now});
      socket = -1;
    }
  }
  if (socket >= 0) ::close(socket);
  wake_.notify_all();
}

void LingeringClose::work() {
  while (take_in()) drop_what_came();
  for (const auto& one : closing_) ::close(one.socket);
}

/// Sleeps while there is nothing to do. False where all is to end.
bool LingeringClose::take_in() {
  std::unique_lock lock(mutex_);
  lingering_ = closing_.size() + taken_.size();
  if (closing_.empty()) wake_.wait(lock, [&] { return ending_ || !taken_.empty(); });
  closing_.insert(closing_.end(), taken_.begin(), taken_.end());
  taken_.clear();
  return !ending_;
}

void LingeringClose::drop_what_came() {
  std::vector<pollfd> sockets;
  sockets.reserve(closing_.size());
  for (const auto& one : closing_) sockets.push_back({one.socket, POLLIN, 0});
  poll(sockets.data(), sockets.size(), between_looks_ms);

  const auto now = Clock::now();
  std::vector<Closing> left;
  for (std::size_t i = 0; i < closing_.size(); ++i) {
    Closing one = closing_[i];
    bool has_hung_up = false;
    if (sockets[i].revents != 0) {
      char dropped[16'384];
      has_hung_up = recv(one.socket, dropped, sizeof(dropped), MSG_DONTWAIT) <= 0;
      one.heard = now;
    }
    if (has_hung_up || now - one.heard > quiet || now - one.began > longest) {
      ::close(one.socket);
    } else {
      left.push_back(one);
    }
  }
  closing_.swap(left);
}

}  // namespace leda::server
