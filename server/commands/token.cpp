#include <fmt/format.h>

#include "server/commands/commands.hpp"
#include "server/commands/exit_code.hpp"
#include "server/http/auth.hpp"

namespace leda::server {
namespace {

struct Options {
  std::string name;
  std::string role = "read";
};

int make_token(const Options& options) {
  const Role role = options.role == "admin"    ? Role::admin
                    : options.role == "submit" ? Role::submit
                                               : Role::read;
  const std::string token = new_token();
  // The token alone on standard output, for whoever gets it; the line for the server's file beside.
  fmt::print("{}\n", token);
  fmt::print(stderr, "line for the file that LEDA_TOKENS names:\n{}\n",
             token_line(token, role, options.name));
  return 0;
}

}  // namespace

void add_token(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("token", "Make a token for somebody");
  command->add_option("name", options->name, "who gets it: letters, digits and - _ . @")
      ->required()
      ->check([](const std::string& name) {
        const bool sound = !name.empty() && name.size() <= 100 &&
                           name.find_first_not_of(
                               "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrst"
                               "uvwxyz0123456789-_.@") == std::string::npos;
        return sound ? "" : "a name of letters, digits and - _ . @";
      });
  command->add_option("--role", options->role, "what they may do")
      ->check(CLI::IsMember({"read", "submit", "admin"}))
      ->capture_default_str();
  command->callback(
      [options, &exit_code] { exit_code = guarded([&] { return make_token(*options); }); });
}

}  // namespace leda::server
