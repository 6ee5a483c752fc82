#pragma once
// The kinds of job Leda knows, and what each does beyond waiting for its sections.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "db/store.hpp"
#include "server/jobs/run_size.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {

/// A job that was understood: how its sections are run, and what is made of their results.
class Work {
 public:
  virtual ~Work() = default;

  /// Every section of the job, in order, waiting or left out with its reason, then the members of
  /// their ensembles, without ground of their own.
  /// @throws Problem invalid_request with every fault that can be known before a run
  virtual std::vector<db::SectionRecord> plan() const = 0;

  /// The sections stand in the store: what only plan() needs is let go.
  virtual void planned() {}

  /// Id of the DEM the job stands on; empty: none.
  virtual std::string raster() const = 0;

  /// What is odd about the ground that all sections stand on.
  virtual std::vector<std::string> warnings() const { return {}; }

  /// The self-contained case file of a section or a member, for `leda simulate`.
  virtual std::string case_file(const db::SectionRecord& section) const = 0;

  /// What screening says of a waiting section; nothing where the job does not screen.
  struct Screened {
    std::string document;  ///< JSON, for the store
    bool skip = false;     ///< clearly stable: not to be simulated
    std::string reason;    ///< the deciding one
  };
  virtual std::optional<Screened> screen(const db::SectionRecord& /*section*/) const { return {}; }

  /// Why a section whose turn has come is not run any more, from what others gave; empty: it is.
  virtual std::string not_needed(const db::SectionRecord& /*section*/) const { return ""; }

  /// Whether not_needed() may spare a section: the least of a dry run is without it.
  virtual bool may_be_spared(const db::SectionRecord& /*section*/) const { return false; }

  /// Sections before this one must have ended before the section at `ordinal` begins.
  virtual std::size_t begins_after(std::size_t /*ordinal*/) const { return 0; }

  /// What the run of a section, or of a member with the ground of its section, will take.
  virtual RunSize size(const db::SectionRecord& section) const = 0;

  virtual PlacedResult place(const db::SectionRecord& section,
                             const SectionResult& result) const = 0;

  /// What all sections together say on the map; empty where the job has no map.
  virtual std::vector<Zone> zones(const std::vector<db::SectionRecord>& sections) const = 0;
};

/// Where jobs find their rasters.
struct Library {
  const DataFolder& data;
  const db::Store& store;
  std::string raster{};  ///< the DEM a stored job stands on; wins over the name in its request
};

struct Process {
  std::string_view id;  ///< "map-region"
  std::string_view title;
  std::string_view description;
  /// Understands the execute request as sent.
  /// @throws Problem invalid_request with every fault
  std::unique_ptr<Work> (*open)(const std::string& request, const Library& library);
  /// "inputs" and "outputs" by name, as OGC API - Processes describes them, and the "definitions"
  /// that the schemas of the inputs refer to.
  nlohmann::json (*describe)();
  /// What the results of a finished job are, as "json", "csv" or "svg"; nullptr: its sections and
  /// zones, as JSON alone.
  std::string (*results)(const db::JobRecord& job, const std::vector<db::SectionRecord>& sections,
                         std::string_view format) = nullptr;
};

std::span<const Process> processes();

/// @return nullptr where there is none
const Process* find_process(std::string_view id);

}  // namespace leda::server
