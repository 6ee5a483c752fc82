#include "server/http/auth.hpp"

#include <openssl/crypto.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "disk/sha256.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {
namespace {

constexpr std::array roles{Role::read, Role::submit, Role::admin};
constexpr std::size_t longest_token = 256;

std::optional<Role> role_from(const std::string& word) {
  for (const Role role : roles) {
    if (word == to_string(role)) return role;
  }
  return std::nullopt;
}

void refuse_writable_by_others(const std::filesystem::path& file) {
  struct stat found {};
  if (stat(file.c_str(), &found) != 0) {
    throw TokenFileError("the file of tokens " + file.string() + " cannot be read");
  }
  if ((found.st_mode & (S_IWGRP | S_IWOTH)) != 0) {
    throw TokenFileError("the file of tokens " + file.string() +
                         " can be written by others: chmod go-w");
  }
}

}  // namespace

const char* to_string(Role role) {
  switch (role) {
    case Role::anyone:
      return "anyone";
    case Role::read:
      return "read";
    case Role::submit:
      return "submit";
    case Role::admin:
      return "admin";
  }
  return "";
}

Tokens::Tokens(const std::filesystem::path& file) {
  refuse_writable_by_others(file);
  std::ifstream in(file);
  std::string line, faults;
  for (int number = 1; std::getline(in, line); ++number) {
    line.erase(std::min(line.find('#'), line.size()));
    std::istringstream words(line);
    std::string role, hash, name;
    if (!(words >> role)) continue;
    words >> hash >> name;
    const auto known = role_from(role);
    if (!known || !disk::is_sha256(hash) || name.empty()) {
      faults += "\n  line " + std::to_string(number) + ": must be ROLE SHA256 NAME, with read, " +
                "submit or admin and 64 hex digits; `leda token` writes one";
      continue;
    }
    entries_.push_back({{name, *known}, hash});
  }
  if (in.bad()) faults += "\n  it cannot be read to its end";
  if (faults.empty() && entries_.empty()) faults = "\n  it holds no token";
  if (!faults.empty()) throw TokenFileError("the file of tokens " + file.string() + ":" + faults);
}

std::optional<TokenHolder> Tokens::holder_of(const std::string& token) const {
  if (token.empty() || token.size() > longest_token) return std::nullopt;
  const std::string hash = disk::sha256_of(token);
  const Entry* found = nullptr;
  for (const Entry& entry : entries_) {
    if (CRYPTO_memcmp(entry.sha256.data(), hash.data(), hash.size()) == 0) found = &entry;
  }
  if (found == nullptr) return std::nullopt;
  return found->holder;
}

std::string new_token() { return "leda_" + random_hex(64); }

std::string token_line(const std::string& token, Role role, const std::string& name) {
  return std::string(to_string(role)) + " " + disk::sha256_of(token) + " " + name;
}

std::string bearer_token(const std::string& authorization) {
  constexpr std::string_view scheme = "Bearer ";
  if (!authorization.starts_with(scheme)) return "";
  const std::string token = authorization.substr(scheme.size());
  const bool plain = std::all_of(token.begin(), token.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("-._~+/=").find(static_cast<char>(c)) != std::string_view::npos;
  });
  return plain ? token : "";
}

}  // namespace leda::server
