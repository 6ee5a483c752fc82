#include "server/documents/settings_reader.hpp"

#include <variant>

namespace leda::server {
namespace {

using nlohmann::json;

Trigger read_trigger(const json& value, const std::string& at, FaultList& faults) {
  ObjectReader reader(value, at, faults);
  const std::string kind = reader.text("kind");
  if (kind == "excavation") {
    ExcavationTrigger excavation;
    if (const json* polygon = reader.require("polygon")) {
      excavation.polygon = read_polyline(*polygon, reader.at("polygon"), faults);
    }
    reader.refuse_unknown();
    return excavation;
  }
  UndrainedTrigger undrained;
  if (kind == "undrained") {
    undrained.then_toe_cut_m = reader.optional_number("then_toe_cut_m");
    reader.refuse_unknown();
  } else if (!kind.empty()) {
    faults.add(reader.at("kind"), "is \"" + kind + "\", must be undrained or excavation");
  }
  return undrained;
}

Resolution read_resolution(const json& value, const std::string& at, FaultList& faults) {
  Resolution resolution;
  ObjectReader reader(value, at, faults);
  resolution.cell_m = reader.number("cell_m");
  const std::int64_t count = reader.integer_or("particles_per_cell", resolution.particles_per_cell);
  // Counts beyond an int are not squares that validate() accepts; -1 is none either.
  resolution.particles_per_cell = count <= 1'000'000 ? int(count) : -1;
  resolution.seed = std::uint64_t(reader.integer_or("seed", 0));
  reader.refuse_unknown();
  return resolution;
}

Damping read_damping(const json& value, const std::string& at, FaultList& faults) {
  Damping damping;
  ObjectReader reader(value, at, faults);
  damping.initial = reader.number_or("initial", damping.initial);
  damping.dynamic = reader.number_or("dynamic", damping.dynamic);
  reader.refuse_unknown();
  return damping;
}

Stop read_stop(const json& value, const std::string& at, FaultList& faults) {
  Stop stop;
  ObjectReader reader(value, at, faults);
  stop.max_time_s = reader.number_or("max_time_s", stop.max_time_s);
  reader.refuse_unknown();
  return stop;
}

Output read_output(const json& value, const std::string& at, FaultList& faults) {
  Output output;
  ObjectReader reader(value, at, faults);
  output.frame_interval_s = reader.number_or("frame_interval_s", output.frame_interval_s);
  output.paraview = reader.boolean_or("paraview", output.paraview);
  reader.refuse_unknown();
  return output;
}

json to_document(const Trigger& trigger) {
  if (const auto* excavation = std::get_if<ExcavationTrigger>(&trigger)) {
    json polygon = json::array();
    for (const Point& p : excavation->polygon) polygon.push_back({p.x, p.z});
    return {{"kind", "excavation"}, {"polygon", polygon}};
  }
  json out{{"kind", "undrained"}};
  const auto& cut = std::get<UndrainedTrigger>(trigger).then_toe_cut_m;
  if (cut) out["then_toe_cut_m"] = *cut;
  return out;
}

}  // namespace

RunSettings read_settings(ObjectReader& reader, FaultList& faults) {
  RunSettings settings;
  if (const json* v = reader.find("trigger")) {
    settings.trigger = read_trigger(*v, reader.at("trigger"), faults);
  }
  if (const json* v = reader.require("resolution")) {
    settings.resolution = read_resolution(*v, reader.at("resolution"), faults);
  }
  if (const json* v = reader.find("damping")) {
    settings.damping = read_damping(*v, reader.at("damping"), faults);
  }
  settings.time_step_factor = reader.number_or("time_step_factor", settings.time_step_factor);
  if (const json* v = reader.find("stop")) {
    settings.stop = read_stop(*v, reader.at("stop"), faults);
  }
  if (const json* v = reader.find("output")) {
    settings.output = read_output(*v, reader.at("output"), faults);
  }
  return settings;
}

void write_settings(const RunSettings& settings, json& document) {
  document["trigger"] = to_document(settings.trigger);
  document["resolution"] = {{"cell_m", settings.resolution.cell_m},
                            {"particles_per_cell", settings.resolution.particles_per_cell},
                            {"seed", settings.resolution.seed}};
  document["damping"] = {{"initial", settings.damping.initial},
                         {"dynamic", settings.damping.dynamic}};
  document["time_step_factor"] = settings.time_step_factor;
  document["stop"] = {{"max_time_s", settings.stop.max_time_s}};
  document["output"] = {{"frame_interval_s", settings.output.frame_interval_s},
                        {"paraview", settings.output.paraview}};
}

}  // namespace leda::server
