// What a slow, endless or pushing client gets, over plain sockets.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "server/http/http_server.hpp"
#include "tests/server/temporary_folder.hpp"

namespace leda::server {
namespace {

using namespace std::chrono_literals;

class Socket {
 public:
  explicit Socket(const std::string& url) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1))));
    inet_pton(AF_INET, "127.0.0.1", &to.sin_addr);
    connected_ = connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof(to)) == 0;
  }
  ~Socket() { close(socket_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  bool connected() const { return connected_; }
  bool say(const std::string& text) const {
    return send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());
  }
  /// Everything until the server closes, or nothing came for a while.
  std::string hear(std::chrono::milliseconds patience = 5s) const {
    std::string heard;
    char buffer[4096];
    pollfd one{socket_, POLLIN, 0};
    while (poll(&one, 1, static_cast<int>(patience.count())) > 0) {
      const ssize_t count = recv(socket_, buffer, sizeof(buffer), 0);
      if (count <= 0) break;
      heard.append(buffer, static_cast<std::size_t>(count));
    }
    return heard;
  }

 private:
  int socket_;
  bool connected_ = false;
};

class ConnectionTest : public testing::Test {
 protected:
  static ServiceOptions options() {
    ServiceOptions options;
    options.program = "/bin/true";
    return options;
  }
  static SiteOptions limited() {
    SiteOptions options;
    options.limits.header_bytes = 4096;
    options.limits.header_time = 400ms;
    options.limits.pause = 300ms;
    options.limits.grace = 500ms;
    options.limits.streams = 2;
    options.limits.connections = 40;
    return options;
  }
  ConnectionTest() { spdlog::set_level(spdlog::level::off); }

  static bool starts(const std::string& text, const std::string& with) {
    return text.starts_with(with);
  }

  tests::TemporaryFolder folder;
  Service service{folder.path(), options()};
  Site site{service, limited()};
  HttpServer http{site, {"127.0.0.1", 0}};
};

TEST_F(ConnectionTest, AHeaderThatIsTooLongIsBrokenOff) {
  const Socket many(site.url);
  std::string header = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n";
  for (int i = 0; i < 500; ++i) header += "X-" + std::to_string(i) + ": 0123456789\r\n";
  many.say(header);
  EXPECT_TRUE(starts(many.hear(), "HTTP/1.1 431 "));
  const Socket endless(site.url);
  endless.say("GET /" + std::string(6000, 'a'));
  EXPECT_TRUE(starts(endless.hear(), "HTTP/1.1 431 "));
}

TEST_F(ConnectionTest, AHeaderThatTricklesIsBrokenOff) {
  const Socket slow(site.url);
  const auto start = std::chrono::steady_clock::now();
  for (const char letter : std::string("GET /healthz HTTP/1.1")) {
    if (!slow.say(std::string(1, letter))) break;
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_TRUE(starts(slow.hear(), "HTTP/1.1 408 "));
  EXPECT_LT(std::chrono::steady_clock::now() - start, 3s);
}

TEST_F(ConnectionTest, ABodyThatNeverComesIsGivenUp) {
  const Socket silent(site.url);
  silent.say(
      "POST /processes/simulate-section/execution HTTP/1.1\r\nHost: localhost\r\n"
      "Content-Length: 1000\r\n\r\n{");
  EXPECT_TRUE(starts(silent.hear(), "HTTP/1.1 408 "));
}

TEST_F(ConnectionTest, ABodyThatTricklesIsGivenUp) {
  const Socket slow(site.url);
  slow.say(
      "POST /processes/simulate-section/execution HTTP/1.1\r\nHost: localhost\r\n"
      "Content-Length: 1000000\r\n\r\n{");
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < 10s) {  // 4 kB/s
    if (!slow.hear(50ms).empty() || !slow.say(std::string(200, ' '))) break;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, 5s) << "at this pace it would take 4 minutes";
}

TEST_F(ConnectionTest, WhoIsBrokenOffWhileSendingCanReadWhy) {
  const Socket pushing(site.url);
  const auto push = [&](const std::string& text) {
    std::this_thread::sleep_for(100ms);  // time for a reset to come
    EXPECT_TRUE(pushing.say(text)) << "reset by the server";
  };
  EXPECT_TRUE(pushing.say("GET /" + std::string(100'000, 'a')));
  push("more");
  push("still more");
  EXPECT_TRUE(starts(pushing.hear(), "HTTP/1.1 431 "));
}

TEST_F(ConnectionTest, RequestsThatComeInOnePieceAreAnsweredInTurn) {
  const Socket pushing(site.url);
  const std::string last = "GET /nothing HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
  pushing.say(
      "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n"
      "POST /processes/simulate-section/execution HTTP/1.1\r\nHost: localhost\r\n"
      "Content-Type: application/json\r\nContent-Length: 2\r\n\r\n{}" +
      last);
  const std::string heard = pushing.hear();
  std::vector<std::string> statuses;
  for (auto at = heard.find("HTTP/1.1 "); at != std::string::npos;
       at = heard.find("HTTP/1.1 ", at + 1)) {
    statuses.push_back(heard.substr(at + 9, 3));
  }
  EXPECT_EQ(statuses, (std::vector<std::string>{"200", "400", "404"})) << heard;
}

TEST_F(ConnectionTest, WhatIsLeftOfABodyIsNotTakenForARequest) {
  const Socket pushing(site.url);
  const std::string smuggled = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n";
  pushing.say("POST /nothing HTTP/1.1\r\nHost: localhost\r\nContent-Length: " +
              std::to_string(smuggled.size()) + "\r\n\r\n" + smuggled);
  const std::string heard = pushing.hear();
  EXPECT_TRUE(starts(heard, "HTTP/1.1 404 ")) << heard;
  EXPECT_EQ(heard.find("HTTP/1.1", 8), std::string::npos) << heard;
}

TEST_F(ConnectionTest, ARefusedBodyIsNotTakenForARequestEither) {
  const Socket pushing(site.url);
  pushing.say(
      "POST /rasters?name=x HTTP/1.1\r\nHost: localhost\r\n"
      "Transfer-Encoding: chunked\r\n\r\n5\r\nhello\r\n0\r\n\r\n"
      "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const std::string heard = pushing.hear();
  EXPECT_TRUE(starts(heard, "HTTP/1.1 411 ")) << heard;
  EXPECT_EQ(heard.find("HTTP/1.1", 8), std::string::npos) << heard;
}

TEST_F(ConnectionTest, LengthsThatCanBeReadInTwoWaysAreRefused) {
  const std::string end = "\r\n\r\nGET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n";
  for (const auto& [header, status] : std::vector<std::pair<std::string, std::string>>{
           {"Transfer-Encoding: \r\nTransfer-Encoding: chunked", "411"},
           {"Content-Length: 3\r\nContent-Length: 40", "400"},
           {"Content-Length: -1", "400"}}) {
    const Socket pushing(site.url);
    pushing.say(std::string("POST /rasters?name=x HTTP/1.1\r\nHost: localhost\r\n")
                    .append(header)
                    .append(end));
    const std::string heard = pushing.hear();
    EXPECT_TRUE(starts(heard, "HTTP/1.1 " + status)) << header << "\n" << heard;
    EXPECT_EQ(heard.find("HTTP/1.1", 8), std::string::npos) << header << "\n" << heard;
  }
  const Socket with_body(site.url);
  with_body.say("GET /healthz HTTP/1.1\r\nHost: localhost\r\nContent-Length: 45" + end);
  const std::string heard = with_body.hear();
  EXPECT_TRUE(starts(heard, "HTTP/1.1 200 ")) << heard;
  EXPECT_EQ(heard.find("HTTP/1.1", 8), std::string::npos) << heard;
}

TEST_F(ConnectionTest, OneConnectionTooManyIsTurnedAway) {
  std::vector<std::unique_ptr<Socket>> idle;
  idle.reserve(60);
  for (int i = 0; i < 60; ++i) idle.push_back(std::make_unique<Socket>(site.url));
  int turned_away = 0;
  for (const auto& socket : idle) {
    ASSERT_TRUE(socket->connected());
    turned_away += starts(socket->hear(20ms), "HTTP/1.1 503 ") ? 1 : 0;
  }
  EXPECT_GE(turned_away, 60 - 40 - 1);
  idle.clear();
  std::this_thread::sleep_for(1500ms);
  const Socket later(site.url);
  later.say("GET /healthz HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(starts(later.hear(), "HTTP/1.1 200 "));
}

TEST_F(ConnectionTest, WhoIsTurnedAwayWhileSendingCanReadWhy) {
  std::vector<std::unique_ptr<Socket>> idle;
  // In groups: of many at once some are turned away before a thread has taken up those before.
  for (int group = 0; group < 3; ++group) {
    for (int i = 0; i < 20; ++i) idle.push_back(std::make_unique<Socket>(site.url));
    std::this_thread::sleep_for(100ms);
  }
  const Socket one_more(site.url);
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(one_more.say("GET /healthz HTTP/1.1\r\n")) << "reset by the server";
    std::this_thread::sleep_for(50ms);
  }
  const std::string heard = one_more.hear();
  EXPECT_TRUE(starts(heard, "HTTP/1.1 503 ")) << heard;
}

TEST_F(ConnectionTest, TwoServersDoNotShareAPort) {
  const std::string port = site.url.substr(site.url.rfind(':') + 1);
  tests::TemporaryFolder other_folder;
  Service other{other_folder.path(), options()};
  Site other_site{other};
  EXPECT_THROW((HttpServer{other_site, {"127.0.0.1", std::stoi(port)}}), ListenError);
}

}  // namespace
}  // namespace leda::server
