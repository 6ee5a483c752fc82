#pragma once
// Who may do what: tokens, of which only hashes are kept.

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace leda::server {

/// What a route asks for, each including the ones before it.
enum class Role {
  anyone,  ///< no token: whether the server lives
  read,
  submit,  ///< also start, retry and dismiss jobs, register DEMs
  admin    ///< also remove what is old
};

const char* to_string(Role role);

class TokenFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct TokenHolder {
  std::string name;
  Role role = Role::read;
};

/// A file with a line a token: "ROLE SHA256 NAME", where ROLE is read, submit or admin, SHA256 the
/// 64 hex digits of the token's hash, and NAME who it was given to. # starts a comment.
class Tokens {
 public:
  /// None: every request may do everything. Only for a server of the loopback interface.
  Tokens() = default;
  /// @throws TokenFileError with every line at fault, and where others may write to the file
  explicit Tokens(const std::filesystem::path& file);

  bool required() const { return !entries_.empty(); }

  /// Who holds a token. Takes the same time whichever token of the file it is, or none.
  std::optional<TokenHolder> holder_of(const std::string& token) const;

 private:
  struct Entry {
    TokenHolder holder;
    std::string sha256;
  };
  std::vector<Entry> entries_;
};

/// A token of 256 random bits, "leda_" and 64 hex digits.
std::string new_token();

/// The line of a token for the file of hashes.
std::string token_line(const std::string& token, Role role, const std::string& name);

/// "Bearer TOKEN" of the header Authorization; empty where it is anything else.
std::string bearer_token(const std::string& authorization);

}  // namespace leda::server
