#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/run_options.hpp"
#include "server/documents/run_folder.hpp"
#include "server/http_server.hpp"
#include "server/logging.hpp"
#include "server/service.hpp"

namespace leda::server {
namespace {

struct Options {
  std::filesystem::path data;
  std::string listen = "127.0.0.1:8080";
  WorkerOptions workers;
};

/// Blocked before any thread starts, so that only wait() hears them.
class EndSignals {
 public:
  EndSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGTERM);
    sigaddset(&signals_, SIGINT);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    signal(SIGPIPE, SIG_IGN);
  }
  int wait() const {
    int heard = 0;
    sigwait(&signals_, &heard);
    return heard;
  }

 private:
  sigset_t signals_{};
};

/// A client that won't let go must not keep the server alive. What is cut off here is taken up
/// again at the next start.
void cut_off_after(std::chrono::milliseconds patience) {
  std::thread([patience] {
    std::this_thread::sleep_for(patience);
    std::_Exit(0);
  }).detach();
}

int serve(const Options& options) {
  set_up_logging(false);
  const auto address = listen_address_from(options.listen);
  const EndSignals end;
  Service service(options.data, service_options(options.workers));
  {
    const HttpServer http(service, address);
    const nlohmann::json where = {{"url", service.url}, {"pid", getpid()}};
    write_whole(service.data.server_file(), where.dump(2) + "\n");
    fmt::print("leda serves {}\n", service.url);
    std::fflush(stdout);
    const int heard = end.wait();
    spdlog::info("ends at signal {}", heard);
    cut_off_after(std::chrono::milliseconds(4500));
    std::error_code ignored;
    std::filesystem::remove(service.data.server_file(), ignored);
  }
  return 0;
}

}  // namespace

void add_serve(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("serve", "Serve HTTP and run jobs");
  command->add_option("--data", options->data, "data folder")->required();
  command->add_option("--listen", options->listen, "HOST:PORT; port 0: any free one")
      ->capture_default_str();
  add_worker_options(*command, options->workers);
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return serve(*options); }); });
}

}  // namespace leda::server
