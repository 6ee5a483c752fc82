#include "disk/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace leda::disk {
namespace {

namespace fs = std::filesystem;

std::string cause_of(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail(const fs::path& file, const char* what, int error) {
  throw FileError(file.string() + " " + what + ": " + cause_of(error));
}

class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags)
      : file_(file), number_(open(file.c_str(), flags | O_CLOEXEC, 0644)) {
    if (number_ < 0) fail(file_, "could not be opened", errno);
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(number_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(file_, "could not be written", errno);
      text.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  // Some file systems tell of a full disk only here.
  void close() {
    const int number = number_;
    number_ = -1;
    if (::close(number) != 0) fail(file_, "could not be written", errno);
  }

 private:
  const fs::path& file_;
  int number_;
};

void write(const fs::path& file, int flags, std::string_view text, std::string_view more) {
  Descriptor out(file, flags);
  out.write(text);
  out.write(more);
  out.close();
}

constexpr int anew = O_WRONLY | O_CREAT | O_TRUNC;

}  // namespace

void write_whole(const fs::path& file, std::string_view text) {
  NewFile whole(file);
  write(whole.part(), anew, text, "");
  whole.keep_in_memory();
}

void write_durably(const fs::path& file, std::string_view text, std::string_view more) {
  NewFile whole(file);
  write(whole.part(), anew, text, more);
  whole.keep();
}

void append_to_file(const fs::path& file, std::string_view text, std::string_view more) {
  write(file, O_WRONLY | O_CREAT | O_APPEND, text, more);
}

bool tells_of_full_disk(const std::exception& error) {
  const std::string_view what = error.what();
  for (const int code : {ENOSPC, EDQUOT, EFBIG}) {
    if (what.find(cause_of(code)) != std::string_view::npos) return true;
  }
  return what.find("database or disk is full") != std::string_view::npos;
}

}  // namespace leda::disk
