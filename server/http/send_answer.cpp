#include "server/http/send_answer.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <utility>
#include <vector>

#include "server/http/problem_answer.hpp"
#include "server/http/ranges.hpp"

namespace leda::server {
namespace {

constexpr std::uint64_t piece_bytes = 1 << 16;

/// The bytes of an answer, in memory or in a file that is read piece by piece.
class Content {
 public:
  explicit Content(std::string text) : text_(std::move(text)), size_(text_.size()) {}
  /// @throws std::runtime_error
  explicit Content(const std::filesystem::path& name)
      : file_(name, std::ios::binary | std::ios::ate) {
    if (!file_) throw std::runtime_error("cannot read " + name.string());
    size_ = static_cast<std::uint64_t>(file_.tellg());
  }

  std::uint64_t size() const { return size_; }

  bool write(std::uint64_t first, std::uint64_t count, httplib::DataSink& sink) {
    if (!file_.is_open()) return sink.write(text_.data() + first, count);
    std::vector<char> piece(std::min(count, piece_bytes));
    file_.seekg(static_cast<std::streamoff>(first));
    file_.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto got = static_cast<std::size_t>(file_.gcount());
    return got > 0 && sink.write(piece.data(), got);
  }

 private:
  std::string text_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
};

/// A text, and after it `count` bytes of the content.
struct Segment {
  std::string text;
  std::uint64_t first = 0, count = 0;
  std::uint64_t size() const { return text.size() + count; }
};

bool write_from(const std::vector<Segment>& segments, std::uint64_t offset, Content& content,
                httplib::DataSink& sink) {
  for (const Segment& segment : segments) {
    if (offset >= segment.size()) {
      offset -= segment.size();
    } else if (offset < segment.text.size()) {
      return sink.write(segment.text.data() + offset, segment.text.size() - offset);
    } else {
      offset -= segment.text.size();
      return content.write(segment.first + offset, segment.count - offset, sink);
    }
  }
  return false;
}

void send_segments(std::vector<Segment> segments, const std::shared_ptr<Content>& content,
                   const std::string& type, httplib::Response& response) {
  std::uint64_t bytes = 0;
  for (const Segment& segment : segments) bytes += segment.size();
  if (bytes == 0) {  // the library takes a provider of nothing for no body at all
    response.set_header("Content-Type", type);
    return;
  }
  response.set_content_provider(bytes, type,
                                [segments = std::move(segments), content](
                                    std::size_t offset, std::size_t, httplib::DataSink& sink) {
                                  return write_from(segments, offset, *content, sink);
                                });
}

std::string content_range(const ByteRange& range, std::uint64_t size) {
  return "bytes " + std::to_string(range.first) + "-" + std::to_string(range.last) + "/" +
         std::to_string(size);
}

Segment segment_of(const ByteRange& range, std::string text = "") {
  return {std::move(text), range.first, range.last - range.first + 1};
}

void send_several(const std::vector<ByteRange>& ranges, const std::shared_ptr<Content>& content,
                  const std::string& type, httplib::Response& response) {
  const std::string boundary = random_hex(32);
  std::vector<Segment> segments;
  for (const ByteRange& range : ranges) {
    const std::string start = (segments.empty() ? "--" : "\r\n--") + boundary;
    segments.push_back(segment_of(
        range, start + "\r\nContent-Type: " + type +
                   "\r\nContent-Range: " + content_range(range, content->size()) + "\r\n\r\n"));
  }
  segments.push_back({"\r\n--" + boundary + "--\r\n"});
  send_segments(std::move(segments), content, "multipart/byteranges; boundary=" + boundary,
                response);
}

/// Ranges are of what If-Range names, and of a success alone; a HEAD has no bytes.
std::string range_of(const httplib::Request& request, const Answer& answer) {
  if (request.method != "GET" || answer.status != 200 || answer.stream) return "";
  const std::string known = request.get_header_value("If-Range");
  const auto tag =
      std::ranges::find(answer.headers, "ETag", &std::pair<std::string, std::string>::first);
  const bool fits = known.empty() || (tag != answer.headers.end() && tag->second == known);
  return fits ? request.get_header_value("Range") : "";
}

/// @return whether parts were sent; all of the content is left to the caller otherwise
bool send_ranges(const std::string& range, const httplib::Request& request,
                 const std::shared_ptr<Content>& content, const std::string& type,
                 httplib::Response& response) {
  const auto ranges = wanted_ranges(range, content->size());
  if (!ranges) return false;
  if (ranges->empty()) {
    const Answer none =
        to_answer(Problem(Failure::no_such_range, "Range is '" + range + "', and there are " +
                                                      std::to_string(content->size()) + " bytes"),
                  request.path);
    response.status = none.status;
    response.set_header("Content-Range", "bytes */" + std::to_string(content->size()));
    response.set_content(none.body, none.type);
    return true;
  }
  response.status = 206;
  if (ranges->size() > 1) {
    send_several(*ranges, content, type, response);
  } else {
    response.set_header("Content-Range", content_range(ranges->front(), content->size()));
    send_segments({segment_of(ranges->front())}, content, type, response);
  }
  return true;
}

/// The library packs bodies for clients that take that, whatever was done to them before.
bool is_packed(const Answer& answer) {
  return std::ranges::any_of(answer.headers,
                             [](const auto& header) { return header.first == "Content-Encoding"; });
}

void send_stream(Site& site, const Answer& answer, httplib::Response& response) {
  response.set_chunked_content_provider(
      answer.type, [&site, next = answer.stream](std::size_t, httplib::DataSink& sink) {
        if (site.stopping || !sink.is_writable()) return false;
        const auto piece = next();
        if (!piece) {
          sink.done();
          return true;
        }
        return piece->empty() || sink.write(piece->data(), piece->size());
      });
}

}  // namespace

void send(Site& site, const httplib::Request& request, Answer& answer,
          httplib::Response& response) {
  response.status = answer.status;
  for (const auto& [name, value] : answer.headers) response.set_header(name, value);
  response.set_header("X-Content-Type-Options", "nosniff");
  if (answer.stream) return send_stream(site, answer, response);
  const std::string range = range_of(request, answer);
  const bool is_read = request.method == "GET" || request.method == "HEAD";
  if (is_read && answer.status == 200) response.set_header("Accept-Ranges", "bytes");
  if (range.empty() && answer.file.empty() && !is_packed(answer)) {
    response.body = std::move(answer.body);  // set_content() would copy it
    if (answer.status != 204) response.set_header("Content-Type", answer.type);
    return;
  }
  const auto content = answer.file.empty() ? std::make_shared<Content>(std::move(answer.body))
                                           : std::make_shared<Content>(answer.file);
  if (send_ranges(range, request, content, answer.type, response)) return;
  send_segments({{"", 0, content->size()}}, content, answer.type, response);
}

}  // namespace leda::server
