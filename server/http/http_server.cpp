#include "server/http/http_server.hpp"

#include <charconv>
#include <thread>

#include "server/http/answer_call.hpp"
#include "server/http/gate.hpp"
#include "server/http/guarded_http.hpp"
#include "server/http/problem_answer.hpp"
#include "server/http/send_answer.hpp"
#include "server/operate/logging.hpp"

namespace leda::server {
namespace {

constexpr std::size_t threads_beside_streams = 24;

std::string path_of(const httplib::Request& request) {
  return request.target.substr(0, request.target.find('?'));
}

HeaderOf headers_of(const httplib::Request& request) {
  return [&request](const std::string& name) { return request.get_header_value(name); };
}

Call call_of(const httplib::Request& request, const httplib::ContentReader* reader) {
  Call call;
  call.method = request.method;
  call.path = request.path;
  call.query.insert(request.params.begin(), request.params.end());
  call.header = headers_of(request);
  const bool has_body =
      reader != nullptr && request.get_header_value<uint64_t>("Content-Length") > 0;
  call.body = [reader, has_body](const std::function<bool(const char*, std::size_t)>& receive) {
    // Without a Content-Length the library would read until the client hangs up.
    return !has_body ||
           (*reader)([&](const char* data, std::size_t n) { return receive(data, n); });
  };
  return call;
}

/// Changes and failures are told; the rest only where somebody looks for it.
void tell(Site& site, const httplib::Request& request, const Told& told, int status,
          double seconds) {
  site.service.metrics.count_request(request.method, told.route, status, seconds);
  const bool matters = request.method != "GET" || status >= 500;
  spdlog::log(matters ? spdlog::level::info : spdlog::level::debug,
              "job={} request method={} route={} status={} ms={:.1f} holder={}", told.job,
              request.method, told.route, status, 1000 * seconds, told.holder);
}

void handle(Site& site, const httplib::Request& request, httplib::Response& response,
            const httplib::ContentReader* reader) {
  const auto start = std::chrono::steady_clock::now();
  bool body_left = request.get_header_value<uint64_t>("Content-Length") > 0;
  Call call = call_of(request, reader);
  call.body = [read = std::move(call.body), &body_left](const auto& receive) {
    const bool whole = read(receive);
    body_left = !whole;
    return whole;
  };
  Told told;
  Answer answer = answer_call(site, call, path_of(request), told);
  send(site, request, answer, response);
  if (body_left) close_after_this_answer();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  tell(site, request, told, response.status, took.count());
}

/// Problems that the library finds by itself get the same form as all others.
void fill_error(const httplib::Request& request, httplib::Response& response) {
  if (has_content(response)) return;
  const auto problem = [&] {
    if (response.status == 413) return Problem(Failure::too_large, "the body is too large");
    if (response.status == 416) {
      return Problem(Failure::no_such_range,
                     "Range is '" + request.get_header_value("Range") + "': give bytes=FIRST-LAST");
    }
    return Problem(Failure::invalid_request, "the request can't be read");
  };
  const Answer answer = to_answer(problem(), request.path);
  response.status = answer.status;
  response.set_content(answer.body, answer.type);
}

/// What the library takes a body out of by itself.
void refuse_unknown_encoding(const httplib::Request& request) {
  const std::string encoding = request.get_header_value("Content-Encoding");
  for (const char* known : {"", "identity", "gzip", "deflate", "br"}) {
    if (encoding == known && request.get_header_value_count("Content-Encoding") <= 1) return;
  }
  throw Problem(Failure::wrong_media_type, "Content-Encoding is '" + encoding +
                                               "': send the body as it is, or gzip, deflate or br");
}

/// Refuses before the body is read. The connection ends then: the body would be left in it.
httplib::Server::HandlerResponse before_routing(const Site& site, const httplib::Request& request,
                                                httplib::Response& response) {
  try {
    // Where a proxy in front and the library read the length of a body in different ways, the rest
    // of one request becomes another.
    if (request.has_header("Transfer-Encoding")) {
      throw Problem(Failure::length_required, "send the body with a Content-Length");
    }
    const std::string length = request.get_header_value("Content-Length");
    if (request.get_header_value_count("Content-Length") > 1 ||
        length.find_first_not_of("0123456789") != std::string::npos) {
      throw Problem(Failure::invalid_request, "the Content-Length must be one whole number");
    }
    refuse_unknown_encoding(request);
    refuse_at_the_gate(headers_of(request), site.tokens, site.url, site.origins);
    return httplib::Server::HandlerResponse::Unhandled;
  } catch (const Problem& problem) {
    const Answer answer = to_answer(problem, request.path);
    response.status = answer.status;
    for (const auto& [name, value] : answer.headers) response.set_header(name, value);
    response.set_content(answer.body, answer.type);
    close_after_this_answer();
    return httplib::Server::HandlerResponse::Handled;
  }
}

void set_up(httplib::Server& http, Site& site) {
  const std::string everything = R"([\s\S]*)";
  const auto plain = [&](const httplib::Request& request, httplib::Response& response) {
    handle(site, request, response, nullptr);
  };
  const auto with_body = [&](const httplib::Request& request, httplib::Response& response,
                             const httplib::ContentReader& reader) {
    handle(site, request, response, &reader);
  };
  http.Get(everything, plain);
  http.Options(everything, plain);
  http.Post(everything, with_body);
  http.Put(everything, with_body);
  http.Patch(everything, with_body);
  http.Delete(everything, plain);
  http.Delete(everything, with_body);
  http.set_payload_max_length(site.limits.raster_bytes);  // documents have a limit of their own
  http.set_tcp_nodelay(true);
  http.set_pre_routing_handler([&](const httplib::Request& request, httplib::Response& response) {
    return before_routing(site, request, response);
  });
  http.set_post_routing_handler([&](const httplib::Request& request, httplib::Response& response) {
    for (const auto& [name, value] : site.origins.headers(request.get_header_value("Origin"))) {
      response.set_header(name, value);
    }
  });
  http.set_error_handler([](const httplib::Request& request, httplib::Response& response) {
    fill_error(request, response);
  });
  http.set_exception_handler([](const httplib::Request& request, httplib::Response& response,
                                const std::exception_ptr& /*thrown*/) {
    const Answer answer =
        to_answer(Problem(Failure::internal, "the answer could not be made"), request.path);
    response.status = answer.status;
    response.set_content(answer.body, answer.type);
  });
}

}  // namespace

ListenAddress listen_address_from(const std::string& text, bool with_tokens) {
  const auto colon = text.rfind(':');
  const std::string host = text.substr(0, colon);
  const std::string port = colon == std::string::npos ? "" : text.substr(colon + 1);
  ListenAddress address{host, -1};
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (host.empty() || error != std::errc{} || end != port.data() + port.size() ||
      address.port < 0 || address.port > 65535) {
    throw ListenError("--listen " + text + ": give HOST:PORT, for example 127.0.0.1:8080");
  }
  if (!with_tokens && !is_local_name(host)) {
    throw ListenError("--listen " + text +
                      ": without tokens only 127.0.0.1, localhost and [::1] are served; name a "
                      "file of tokens in LEDA_TOKENS for others (`leda token` makes one)");
  }
  if (host.starts_with('[') && host.ends_with(']')) {
    address.host = host.substr(1, host.size() - 2);
  }
  return address;
}

struct HttpServer::Running {
  explicit Running(Site& of)
      : site(of), http(of.limits, threads_beside_streams + of.limits.streams) {}
  Site& site;
  GuardedHttp http;
  std::thread thread;
};

HttpServer::HttpServer(Site& site, const ListenAddress& address)
    : running_(std::make_unique<Running>(site)) {
  GuardedHttp& guarded = running_->http;
  httplib::Server& http = guarded.server();
  set_up(http, site);
  int port = address.port;
  const bool bound = port == 0 ? (port = http.bind_to_any_port(address.host)) > 0
                               : http.bind_to_port(address.host, port);
  const bool is_v6 = address.host.find(':') != std::string::npos;
  const std::string shown = is_v6 ? "[" + address.host + "]" : address.host;
  if (!bound) {
    throw ListenError("cannot listen on " + shown + ":" + std::to_string(address.port) +
                      ": is the port in use?");
  }
  guarded.lengthen_backlog();
  site.url =
      site.public_url.empty() ? "http://" + shown + ":" + std::to_string(port) : site.public_url;
  site.connections = [&guarded] { return guarded.connections(); };
  running_->thread = std::thread([&http] { http.listen_after_bind(); });
}

HttpServer::~HttpServer() {
  running_->site.stopping = true;
  running_->http.end_soon();
  running_->http.server().stop();
  if (running_->thread.joinable()) running_->thread.join();
  running_->site.connections = [] { return std::size_t{0}; };
}

}  // namespace leda::server
