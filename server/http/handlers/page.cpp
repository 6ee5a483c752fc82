#include "server/http/handlers/page.hpp"

#include "server/http/accept.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/operate/problem.hpp"
#include "server/page/page_files.hpp"

namespace leda::server {
namespace {

constexpr std::string_view document_name = "index.html";

/// Scripts, styles and answers of this server alone; pictures also from what the page itself made
/// of an answer, since a picture's address carries no token.
constexpr const char* policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

bool takes_gzip(const Call& call) {
  constexpr int named = 3;
  const Want gzip = wanted(call.header("Accept-Encoding"), "gzip");
  return gzip.exactness == named && gzip.quality > 0;
}

Answer file_answer(const PageFile& file, const Call& call) {
  const bool packed = takes_gzip(call);
  const std::string tag = "\"" + std::string(file.hash) + (packed ? "-gzip\"" : "\"");
  if (has_already(call, tag)) return not_modified(tag);
  Answer answer;
  answer.type = file.type;
  answer.body = packed ? file.gzip : file.bytes;
  if (packed) answer.headers.emplace_back("Content-Encoding", "gzip");
  answer.headers.emplace_back("ETag", tag);
  answer.headers.emplace_back("Cache-Control", "no-cache");
  answer.headers.emplace_back("Vary", "Accept-Encoding");
  return answer;
}

}  // namespace

bool has_page() { return find_page_file(document_name) != nullptr; }

Answer page_answer(const Call& call) {
  Answer answer = file_answer(*find_page_file(document_name), call);
  answer.headers.emplace_back("Content-Security-Policy", policy);
  answer.headers.emplace_back("Referrer-Policy", "no-referrer");
  return answer;
}

Answer get_page_file(Site& /*site*/, const Call& call) {
  const PageFile* file = find_page_file(call.captured[0]);
  if (file == nullptr || file->name == document_name) {
    throw Problem(Failure::no_such_resource, "the page has no file " + call.captured[0]);
  }
  return file_answer(*file, call);
}

}  // namespace leda::server
