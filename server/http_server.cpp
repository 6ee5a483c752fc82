#include "server/http_server.hpp"

#include <httplib.h>
#include <spdlog/spdlog.h>

#include <charconv>
#include <fstream>
#include <thread>

#include "server/problem.hpp"
#include "server/routes.hpp"

namespace leda::server {
namespace {

constexpr std::size_t most_body_bytes = std::size_t{4} << 30;  // a DEM; documents have their own
constexpr std::size_t threads = 24 + Service::most_streams;

std::string path_of(const httplib::Request& request) {
  return request.target.substr(0, request.target.find('?'));
}

/// A page of another site must not steer a server that trusts its own machine.
bool is_local_name(std::string host) {
  if (const auto scheme = host.find("://"); scheme != std::string::npos) host.erase(0, scheme + 3);
  if (host.starts_with("[")) return host.starts_with("[::1]");
  host.erase(std::min(host.find(':'), host.size()));
  return host == "127.0.0.1" || host == "localhost";
}

std::optional<Problem> refusal(const httplib::Request& request) {
  if (request.has_header("Transfer-Encoding")) {
    return Problem(Failure::length_required, "send the body with a Content-Length");
  }
  if (request.is_multipart_form_data()) {
    return Problem(Failure::wrong_media_type, "send the document itself as the body, not a form");
  }
  for (const char* name : {"Host", "Origin"}) {
    if (request.has_header(name) && !is_local_name(request.get_header_value(name))) {
      return Problem(Failure::foreign_origin,
                     std::string("the ") + name + " header names another machine");
    }
  }
  return std::nullopt;
}

Call call_of(const httplib::Request& request, const httplib::ContentReader* reader) {
  Call call;
  call.method = request.method;
  call.path = request.path;
  call.query.insert(request.params.begin(), request.params.end());
  call.header = [&request](const std::string& name) { return request.get_header_value(name); };
  const bool has_body =
      reader != nullptr && request.get_header_value<uint64_t>("Content-Length") > 0;
  call.body = [reader, has_body](const std::function<bool(const char*, std::size_t)>& receive) {
    // Without a Content-Length the library would read until the client hangs up.
    return !has_body ||
           (*reader)([&](const char* data, std::size_t n) { return receive(data, n); });
  };
  return call;
}

Answer answer_to(Service& service, Call& call, const std::string& target, std::string& route) {
  const RouteMatch match = find_route(routes(), call.method, target);
  if (match.route == nullptr && match.other_methods.empty()) {
    throw Problem(Failure::no_such_resource, "there is nothing at " + call.path);
  }
  if (match.route == nullptr) {
    Answer answer =
        to_answer(Problem(Failure::wrong_method, call.method + " is not possible on " + call.path),
                  call.path);
    std::string allowed;
    for (const auto& method : match.other_methods) {
      allowed += (allowed.empty() ? "" : ", ") + method;
    }
    answer.headers.emplace_back("Allow", allowed);
    return answer;
  }
  route = match.route->path;
  call.captured = match.captured;
  if (const auto unknown = unknown_parameters(*match.route, call); !unknown.empty()) {
    std::vector<Fault> faults;
    for (const auto& name : unknown) faults.push_back({"", "unknown query parameter: " + name});
    throw Problem(Failure::invalid_parameter, "known here: " + std::string(match.route->parameters),
                  faults);
  }
  return match.route->handler(service, call);
}

Answer safe_answer(Service& service, Call& call, const std::string& target, std::string& route) {
  try {
    return answer_to(service, call, target, route);
  } catch (const Problem& problem) {
    return to_answer(problem, call.path);
  } catch (const std::exception& error) {
    const std::string reference = random_hex(8);
    spdlog::error("request {} failed ({} {}): {}", reference, call.method, route, error.what());
    return to_answer(
        Problem(Failure::internal, "the server's log has the cause under " + reference), call.path);
  }
}

void send_file(const std::filesystem::path& name, const std::string& type,
               httplib::Response& response) {
  auto file = std::make_shared<std::ifstream>(name, std::ios::binary | std::ios::ate);
  if (!*file) throw std::runtime_error("cannot read " + name.string());
  response.set_content_provider(
      static_cast<std::size_t>(file->tellg()), type,
      [file](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        std::vector<char> piece(std::min<std::size_t>(length, 1 << 16));
        file->seekg(static_cast<std::streamoff>(offset));
        file->read(piece.data(), static_cast<std::streamsize>(piece.size()));
        const auto count = static_cast<std::size_t>(file->gcount());
        return count > 0 && sink.write(piece.data(), count);
      });
}

void send_stream(Service& service, const Answer& answer, httplib::Response& response) {
  response.set_chunked_content_provider(
      answer.type, [&service, next = answer.stream](std::size_t, httplib::DataSink& sink) {
        if (service.stopping || !sink.is_writable()) return false;
        const auto piece = next();
        if (!piece) {
          sink.done();
          return true;
        }
        return piece->empty() || sink.write(piece->data(), piece->size());
      });
}

void send(Service& service, const Answer& answer, httplib::Response& response) {
  response.status = answer.status;
  for (const auto& [name, value] : answer.headers) response.set_header(name, value);
  response.set_header("X-Content-Type-Options", "nosniff");
  if (answer.stream) {
    send_stream(service, answer, response);
  } else if (!answer.file.empty()) {
    send_file(answer.file, answer.type, response);
  } else {
    response.set_content(answer.body, answer.type);
  }
}

void handle(Service& service, const httplib::Request& request, httplib::Response& response,
            const httplib::ContentReader* reader) {
  const auto start = std::chrono::steady_clock::now();
  Call call = call_of(request, reader);
  std::string route = "none";
  const Answer answer = safe_answer(service, call, path_of(request), route);
  send(service, answer, response);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  service.metrics.count_request(request.method, route, answer.status, took.count());
}

/// Problems that the library finds by itself get the same form as all others.
void fill_error(const httplib::Request& request, httplib::Response& response) {
  if (!response.body.empty() || response.content_length_ > 0) return;
  const bool too_large = response.status == 413;
  const Problem problem(too_large ? Failure::too_large : Failure::invalid_request,
                        too_large ? "the body is too large" : "the request can't be read");
  const Answer answer = to_answer(problem, request.path);
  response.status = answer.status;
  response.set_content(answer.body, answer.type);
}

void set_up(httplib::Server& http, Service& service) {
  const std::string everything = R"([\s\S]*)";
  const auto plain = [&service](const httplib::Request& request, httplib::Response& response) {
    handle(service, request, response, nullptr);
  };
  const auto with_body = [&service](const httplib::Request& request, httplib::Response& response,
                                    const httplib::ContentReader& reader) {
    handle(service, request, response, &reader);
  };
  http.Get(everything, plain);
  http.Options(everything, plain);
  http.Post(everything, with_body);
  http.Put(everything, with_body);
  http.Patch(everything, with_body);
  http.Delete(everything, plain);
  http.Delete(everything, with_body);
  http.new_task_queue = [] { return new httplib::ThreadPool(threads); };
  http.set_payload_max_length(most_body_bytes);
  http.set_keep_alive_max_count(1000);
  http.set_keep_alive_timeout(1);
  http.set_tcp_nodelay(true);
  http.set_pre_routing_handler([](const httplib::Request& request, httplib::Response& response) {
    const auto refused = refusal(request);
    if (!refused) return httplib::Server::HandlerResponse::Unhandled;
    const Answer answer = to_answer(*refused, request.path);
    response.status = answer.status;
    response.set_content(answer.body, answer.type);
    return httplib::Server::HandlerResponse::Handled;
  });
  http.set_error_handler([](const httplib::Request& request, httplib::Response& response) {
    fill_error(request, response);
  });
  http.set_exception_handler(
      [](const httplib::Request& request, httplib::Response& response, std::exception_ptr) {
        const Answer answer =
            to_answer(Problem(Failure::internal, "the answer could not be made"), request.path);
        response.status = answer.status;
        response.set_content(answer.body, answer.type);
      });
}

}  // namespace

ListenAddress listen_address_from(const std::string& text) {
  const auto colon = text.rfind(':');
  const std::string host = text.substr(0, colon);
  const std::string port = colon == std::string::npos ? "" : text.substr(colon + 1);
  ListenAddress address{host, -1};
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (error != std::errc{} || end != port.data() + port.size() || address.port < 0 ||
      address.port > 65535) {
    throw ListenError("--listen " + text + ": give HOST:PORT, for example 127.0.0.1:8080");
  }
  if (!is_local_name(host)) {
    throw ListenError("--listen " + text +
                      ": only 127.0.0.1, localhost and [::1] are served, since requests carry no "
                      "token; put a proxy with a login in front for others");
  }
  if (address.host == "[::1]") address.host = "::1";
  return address;
}

struct HttpServer::Running {
  explicit Running(Service& of) : service(of) {}
  Service& service;
  httplib::Server http;
  std::thread thread;
};

HttpServer::HttpServer(Service& service, const ListenAddress& address)
    : running_(std::make_unique<Running>(service)) {
  set_up(running_->http, service);
  int port = address.port;
  const bool bound = port == 0 ? (port = running_->http.bind_to_any_port(address.host)) > 0
                               : running_->http.bind_to_port(address.host, port);
  const std::string shown = address.host == "::1" ? "[::1]" : address.host;
  if (!bound) {
    throw ListenError("cannot listen on " + shown + ":" + std::to_string(address.port) +
                      ": is the port in use?");
  }
  service.url = "http://" + shown + ":" + std::to_string(port);
  running_->thread = std::thread([this] { running_->http.listen_after_bind(); });
}

HttpServer::~HttpServer() {
  running_->service.stopping = true;
  running_->http.stop();
  if (running_->thread.joinable()) running_->thread.join();
}

}  // namespace leda::server
