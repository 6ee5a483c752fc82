#include "server/jobs/executors/slurm/settings.hpp"

namespace leda::server {
namespace {

constexpr std::size_t longest_interpreter = 200;  // the kernel cuts "#!" lines at 255 bytes

bool has_blank(const std::string& text) {
  return text.find_first_of(" \t\r\n") != std::string::npos;
}

bool is_word(const std::string& text) { return !has_blank(text) && !text.starts_with('-'); }

}  // namespace

std::vector<std::string> faults_of(const SlurmSettings& settings) {
  std::vector<std::string> faults;
  const std::string program = settings.program.string();
  if (!settings.program.is_absolute() || has_blank(program) ||
      program.size() > longest_interpreter) {
    faults.push_back("slurm-program \"" + program + "\": must be an absolute path of at most " +
                     std::to_string(longest_interpreter) + " characters without blanks");
  }
  if (!is_word(settings.partition)) {
    faults.push_back("slurm-partition \"" + settings.partition + "\": must be one name");
  }
  if (!is_word(settings.account)) {
    faults.push_back("slurm-account \"" + settings.account + "\": must be one name");
  }
  for (const auto& option : settings.options) {
    if (!option.starts_with("--") || option.size() < 3) {
      faults.push_back("slurm-option \"" + option + "\": must be as in --constraint=NAME");
    }
  }
  if (!settings.shared_folder.empty() && !std::filesystem::is_directory(settings.shared_folder)) {
    faults.push_back("slurm-shared-folder \"" + settings.shared_folder.string() +
                     "\": must be a folder that stands");
  }
  return faults;
}

}  // namespace leda::server
