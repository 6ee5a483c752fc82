#include "server/operate/data_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

namespace leda::server {
namespace {

DataFolderError failure(const std::string& what, const std::filesystem::path& file) {
  DataFolderError error(what + " " + file.string() + ": " + std::strerror(errno));
  return error;
}

}  // namespace

DataFolder::DataFolder(const std::filesystem::path& root) {
  std::error_code error;
  root_ = std::filesystem::absolute(root, error).lexically_normal();
  for (const auto& folder : {root_, rasters(), runs(), exports(), uploads()}) {
    std::filesystem::create_directories(folder, error);
    if (error) {
      throw DataFolderError("cannot make the folder " + folder.string() + ": " + error.message());
    }
  }
}

std::string DataFolder::without_root(std::string text) const {
  const std::string root = root_.string();
  for (auto at = text.find(root); at != std::string::npos; at = text.find(root, at)) {
    const std::size_t end = at + root.size();
    text.erase(at, root.size() + (end < text.size() && text[end] == '/' ? 1 : 0));
  }
  return text;
}

RunnerLock::RunnerLock(const DataFolder& data) {
  const auto name = data.root() / "runner.lock";
  file_ = open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file_ < 0) throw failure("cannot open", name);
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    close(file_);
    throw DataFolderError("another leda process runs the jobs of " + data.root().string() +
                          ": stop it, or use another --data folder");
  }
}

RunnerLock::~RunnerLock() { close(file_); }

std::string read_whole(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw failure("cannot read", file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string random_hex(std::size_t count) {
  std::random_device device;
  std::string text;
  while (text.size() < count) text += "0123456789abcdef"[device() & 15U];
  return text;
}

}  // namespace leda::server
