#include "server/http/send_answer.hpp"

#include <fstream>
#include <memory>
#include <utility>
#include <vector>

namespace leda::server {
namespace {

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

}  // namespace

void send(Service& service, Answer& answer, httplib::Response& response) {
  response.status = answer.status;
  for (const auto& [name, value] : answer.headers) response.set_header(name, value);
  response.set_header("X-Content-Type-Options", "nosniff");
  if (answer.stream) {
    send_stream(service, answer, response);
  } else if (!answer.file.empty()) {
    send_file(answer.file, answer.type, response);
  } else {
    response.body = std::move(answer.body);  // set_content() would copy it
    response.set_header("Content-Type", answer.type);
  }
}

}  // namespace leda::server
