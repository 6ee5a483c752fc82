#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/run_options.hpp"
#include "server/http/http_server.hpp"
#include "server/jobs/service.hpp"
#include "server/operate/logging.hpp"
#include "server/operate/memory_return.hpp"
#include "server/operate/settings_file.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {
namespace {

struct Options {
  std::filesystem::path data;
  std::string listen = "127.0.0.1:8080";
  std::string public_url;
  std::filesystem::path tokens;
  std::vector<std::string> cors_origins;
  WorkerOptions workers;
  JobLimits job_limits;
  Limits limits;
};

/// Links in answers have to lead back to the server.
void refuse_unreachable(const Options& options, const ListenAddress& address) {
  const bool any_address = address.host == "0.0.0.0" || address.host == "::";
  if (any_address && options.public_url.empty()) {
    throw ListenError("--listen " + options.listen +
                      ": every address of this machine; say with --public-url how it is reached");
  }
  const std::string& url = options.public_url;
  const bool sound = url.empty() || ((url.starts_with("http://") || url.starts_with("https://")) &&
                                     !url.ends_with('/') &&
                                     url.find_first_of(" \"<>\\\r\n?#") == std::string::npos);
  if (!sound) {
    throw ListenError("--public-url " + url + ": give http(s)://HOST, without a slash at the end");
  }
}

AllowedOrigins origins_of(const Options& options, bool with_tokens) {
  AllowedOrigins origins(options.cors_origins);
  std::string text;
  for (const auto& fault : origins.faults(with_tokens)) text += (text.empty() ? "" : "\n") + fault;
  if (!text.empty()) throw ListenError(text);
  return origins;
}

SiteOptions site_options(const Options& options) {
  SiteOptions site;
  site.limits = options.limits;
  site.public_url = options.public_url;
  if (!options.tokens.empty()) site.tokens = Tokens(options.tokens);
  site.origins = origins_of(options, site.tokens.required());
  return site;
}

ServiceOptions service_options(const Options& options) {
  ServiceOptions service = service_options(options.workers);
  service.limits = options.job_limits;
  return service;
}

/// Blocked before any thread starts, so that only wait() hears them.
class EndSignals {
 public:
  EndSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGTERM);
    sigaddset(&signals_, SIGINT);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    static_cast<void>(signal(SIGPIPE, SIG_IGN));
    // A limit on the size of files tells itself as an error.
    static_cast<void>(signal(SIGXFSZ, SIG_IGN));
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
  keep_little_free_memory();
  set_up_logging(false);
  const ServiceOptions wanted = service_options(options);
  const SiteOptions shown = site_options(options);
  const auto address = listen_address_from(options.listen, shown.tokens.required());
  refuse_unreachable(options, address);
  const EndSignals end;
  Service service(options.data, wanted);
  Site site(service, shown);
  {
    const HttpServer http(site, address);
    const nlohmann::json where = {{"url", site.url}, {"pid", getpid()}};
    disk::write_whole(service.data.server_file(), where.dump(2) + "\n");
    fmt::print("leda serves {}\n", site.url);
    static_cast<void>(std::fflush(stdout));
    log_info("-", "serves url={} tokens={}", site.url, site.tokens.required());
    const int heard = end.wait();
    log_info("-", "ends signal={}", heard);
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
  add_settings_file(*command);
  command->add_option("--data", options->data, "data folder")->required();
  command->add_option("--listen", options->listen, "HOST:PORT; port 0: any free one")
      ->capture_default_str();
  command->add_option("--public-url", options->public_url,
                      "how clients reach the server, where that is not --listen (a proxy)");
  command->add_option("--tokens", options->tokens, "file of hashed tokens; see leda token")
      ->envname("LEDA_TOKENS");
  command
      ->add_option(
          "--cors-origin", options->cors_origins,
          "whose pages may ask from a browser, as https://maps.example.org; * with tokens: "
          "any; repeated")
      ->allow_extra_args(false);
  JobLimits& job_limits = options->job_limits;
  Limits& limits = options->limits;
  command->add_option("--most-connections", limits.connections, "at once; more get 503")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  command->add_option("--most-streams", limits.streams, "of events, open at once")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--most-raster-bytes", limits.raster_bytes, "of a DEM's file")
      ->check(CLI::Range(std::uint64_t{1} << 10, std::uint64_t{1} << 40))
      ->capture_default_str();
  command->add_option("--most-jobs", job_limits.unfinished_jobs, "unfinished; more get 429")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--most-sections", job_limits.sections, "of a job")
      ->check(CLI::Range(1, 20'000))
      ->capture_default_str();
  command->add_option("--most-particles", job_limits.particles, "of all runs of a job together")
      ->check(CLI::Range(1.0, 1e15))
      ->capture_default_str();
  add_worker_options(*command, options->workers);
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return serve(*options); }); });
}

}  // namespace leda::server
