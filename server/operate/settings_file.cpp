#include "server/operate/settings_file.hpp"

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <sstream>

namespace leda::server {
namespace {

/// A value as the command line would have it.
std::string as_argument(const toml::node& value) {
  if (const auto text = value.value_exact<std::string>()) return *text;
  std::ostringstream out;
  value.visit([&](const auto& node) { out << node; });
  return out.str();
}

std::vector<std::string> arguments_of(const toml::node& value) {
  std::vector<std::string> arguments;
  if (const auto* list = value.as_array()) {
    for (const auto& part : *list) arguments.push_back(as_argument(part));
  } else {
    arguments.push_back(as_argument(value));
  }
  return arguments;
}

class SettingsReader {
 public:
  SettingsReader(CLI::App& command, std::string file) : command_(command), file_(std::move(file)) {}

  void read() {
    const toml::parse_result settings = toml::parse_file(file_);
    if (!settings) {
      add(settings.error().source().begin.line, std::string(settings.error().description()));
    } else {
      read(settings.table(), "");
    }
    if (!faults_.empty()) throw CLI::ValidationError("--settings", faults_);
  }

 private:
  void read(const toml::table& table, const std::string& section) {
    for (const auto& [key, value] : table) {
      const std::string name = section + std::string(key.str());
      if (const auto* inner = value.as_table()) {
        read(*inner, name + "_");
      } else {
        set(name, value);
      }
    }
  }

  void set(const std::string& name, const toml::node& value) {
    const auto line = value.source().begin.line;
    std::string option_name = "--" + name;
    std::replace(option_name.begin(), option_name.end(), '_', '-');
    CLI::Option* option = command_.get_option_no_throw(option_name);
    if (option == nullptr || name == "settings" || name == "help") {
      add(line, "there is no setting " + name);
      return;
    }
    if (option->count() > 0) return;  // the command line wins
    try {
      option->add_result(arguments_of(value));
      option->run_callback();
    } catch (const CLI::Error& fault) {
      add(line, name + ": " + fault.what());
    }
  }

  void add(toml::source_index line, const std::string& what) {
    faults_ += "\n  " + file_ + " line " + std::to_string(line) + ": " + what;
  }

  CLI::App& command_;
  std::string file_;
  std::string faults_;
};

}  // namespace

void add_settings_file(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--settings",
          [&command](const std::string& file) { SettingsReader(command, file).read(); },
          "file of settings (TOML); the command line wins over it")
      ->check(CLI::ExistingFile);
}

}  // namespace leda::server
