#include "server/jobs/executors/slurm/array_notes.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "disk/sha256.hpp"
#include "server/operate/data_folder.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {

namespace fs = std::filesystem;
using nlohmann::json;

ArrayNote read_note(const fs::path& file) {
  try {
    const json document = json::parse(read_whole(file));
    ArrayNote note;
    note.name = document.at("name");
    note.id = document.at("id");
    note.program = document.at("program").get<std::string>();
    note.limits.memory_bytes = document.at("memory_bytes");
    note.limits.cpu_s = document.at("cpu_s");
    for (const auto& folder : document.at("folders")) {
      note.folders.emplace_back(folder.get<std::string>());
    }
    return note;
  } catch (const json::exception& fault) {
    throw std::runtime_error(file.string() + " is no note of an array: " + fault.what());
  }
}

ArrayNotes::ArrayNotes(const fs::path& folder) {
  fs::create_directories(folder);
  folder_ = fs::canonical(folder);
  prefix_ = "leda-" + disk::sha256_of(folder_.string()).substr(0, 8) + "-";
}

std::vector<ArrayNote> ArrayNotes::read() const {
  std::vector<ArrayNote> found;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const auto& file = entry.path();
    if (file.extension() == ".json" && file.filename().string().starts_with(prefix_)) {
      found.push_back(read_note(file));
    }
  }
  return found;
}

std::string ArrayNotes::new_name() const { return prefix_ + random_hex(12); }

void ArrayNotes::write(const ArrayNote& note) const {
  json folders = json::array();
  for (const auto& folder : note.folders) folders.push_back(folder.string());
  const json document = {{"name", note.name},
                         {"id", note.id},
                         {"program", note.program.string()},
                         {"memory_bytes", note.limits.memory_bytes},
                         {"cpu_s", note.limits.cpu_s},
                         {"folders", folders}};
  disk::write_durably(file(note.name), document.dump(1) + "\n");
}

void ArrayNotes::remove(const std::string& name) const {
  std::error_code ignored;
  fs::remove(output(name), ignored);
  fs::remove(file(name), ignored);
}

}  // namespace leda::server
