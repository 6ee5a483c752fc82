#include "server/jobs/executors/slurm/cluster.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

namespace leda::server {
namespace {

constexpr std::size_t most_cancelled_at_once = 500;
constexpr std::streamoff most_of_completion_file = std::streamoff{64} << 20;

/// The first line that says something.
std::string first_line(const std::string& text) {
  const auto start = text.find_first_not_of(" \n");
  if (start == std::string::npos) return "no reason given";
  return text.substr(start, std::min(text.find('\n', start) - start, std::size_t{300}));
}

/// Whether the same request may be accepted at another time. What Slurm says when it does not
/// answer, and when its queue or a quota is full.
bool is_passing(const std::string& words) {
  constexpr std::array signs{"Unable to contact", "timed out",      "Zero Bytes", "temporarily",
                             "try again",         "limit",          "Limit",      "Resource temp",
                             "not responding",    "Slurm backup",   "in standby", "Connection",
                             "connection",        "Communication",  "Protocol",   "protocol",
                             "partition is down", "is unavailable", "munge",      "Munge"};
  return std::any_of(signs.begin(), signs.end(),
                     [&](const char* sign) { return words.find(sign) != std::string::npos; });
}

/// Lines about one array at the end of a file that may have grown for years.
std::string lines_about(const std::filesystem::path& file, const std::string& name) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return "";
  in.seekg(std::max<std::streamoff>(0, in.tellg() - most_of_completion_file));
  std::string line, found;
  while (std::getline(in, line)) {
    if (line.find(" Name=" + name + " ") != std::string::npos) found += line + "\n";
  }
  return found;
}

}  // namespace

Cluster::Cluster(SlurmSettings settings, RunLimits limits, const std::atomic<bool>& stop)
    : settings_(std::move(settings)), limits_(limits), stop_(stop) {}

Said Cluster::ask(const std::vector<std::string>& arguments) const {
  Said said = ask_program(arguments, settings_.patience, stop_);
  if (!said.ended && said.errors.empty()) said.errors = arguments.front() + " did not answer";
  if (!said.ended || said.exit_code != 0) why_ = first_line(said.errors);
  return said;
}

Cluster::Answer Cluster::submit(const ArrayNotes& notes, const ArrayNote& note,
                                const std::vector<std::size_t>& indices) const {
  std::string range = array_range(indices);
  if (settings_.most_running > 0) range += "%" + std::to_string(settings_.most_running);
  std::vector<std::string> arguments{"sbatch",
                                     "--parsable",
                                     "--array=" + range,
                                     "--job-name=" + note.name,
                                     "--output=" + notes.output(note.name).string(),
                                     "--open-mode=append",
                                     "--chdir=/",
                                     "--export=NIL",
                                     "--requeue",
                                     "--ntasks=1",
                                     "--cpus-per-task=1"};
  if (!settings_.partition.empty()) arguments.push_back("--partition=" + settings_.partition);
  if (!settings_.account.empty()) arguments.push_back("--account=" + settings_.account);
  if (limits_.memory_bytes > 0) {
    arguments.push_back("--mem=" + std::to_string((limits_.memory_bytes + (1 << 20) - 1) >> 20));
  }
  if (limits_.wall.count() > 0) {  // Slurm counts in minutes
    arguments.push_back("--time=" + std::to_string((limits_.wall.count() + 59) / 60));
  }
  arguments.insert(arguments.end(), settings_.options.begin(), settings_.options.end());
  arguments.push_back(notes.batch_script().string());
  arguments.push_back(notes.file(note.name).string());

  const Said said = ask(arguments);
  if (!said.ended) return {Answer::Kind::later, why_};
  if (said.exit_code != 0) {
    return {is_passing(said.errors) ? Answer::Kind::later : Answer::Kind::refused, why_};
  }
  const std::string id = said.out.substr(0, said.out.find_first_of(";\n"));
  if (id.empty() || id.find_first_not_of("0123456789") != std::string::npos) {
    return {Answer::Kind::later, "sbatch gave no number: " + first_line(said.out)};
  }
  return {Answer::Kind::accepted, id};
}

std::optional<Cluster::States> Cluster::queue(const std::string& prefix) const {
  const Said said = ask({"squeue", "-r", "-h", "--me", "-o", "%F|%K|%T|%j"});
  if (!said.ended || said.exit_code != 0) return std::nullopt;
  States states = read_queue(said.out);
  std::erase_if(states, [&](const auto& entry) { return !entry.first.first.starts_with(prefix); });
  return states;
}

std::optional<Cluster::States> Cluster::records(const std::string& name,
                                                const std::string& id) const {
  const Said said = ask({"scontrol", "-o", "show", "job", id});
  const bool forgotten = said.errors.find("Invalid job id") != std::string::npos;
  if (!said.ended || (said.exit_code != 0 && !forgotten)) return std::nullopt;
  States states = read_records(said.out);
  if (!settings_.completion_file.empty()) {
    states.merge(read_records(lines_about(settings_.completion_file, name)));
  }
  std::erase_if(states, [&](const auto& entry) { return entry.first.first != name; });
  return states;
}

void Cluster::cancel(const std::vector<std::string>& tasks) const {
  for (std::size_t from = 0; from < tasks.size(); from += most_cancelled_at_once) {
    const auto to = std::min(tasks.size(), from + most_cancelled_at_once);
    std::vector<std::string> arguments{"scancel", "--quiet"};
    arguments.insert(arguments.end(), tasks.begin() + static_cast<std::ptrdiff_t>(from),
                     tasks.begin() + static_cast<std::ptrdiff_t>(to));
    ask(arguments);
  }
}

}  // namespace leda::server
