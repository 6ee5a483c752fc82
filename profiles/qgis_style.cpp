#include "profiles/qgis_style.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace leda::profiles {
namespace {

using Properties = std::vector<std::pair<std::string, std::string>>;

// QGIS 3.22 reads <prop>, newer ones <Option>.
std::string symbol(const std::string& type, const std::string& name, const std::string& layer,
                   const Properties& properties) {
  std::string options, props;
  for (const auto& [key, value] : properties) {
    options += fmt::format(R"(<Option type="QString" name="{}" value="{}"/>)", key, value);
    props += fmt::format(R"(<prop k="{}" v="{}"/>)", key, value);
  }
  return fmt::format(
      R"(<symbol type="{}" name="{}" alpha="1" clip_to_extent="1" force_rhr="0">)"
      R"(<layer class="{}" enabled="1" locked="0" pass="0"><Option type="Map">{}</Option>{}</layer>)"
      "</symbol>",
      type, name, layer, options, props);
}

std::string fill(const std::string& name, const std::string& colour, const std::string& outline,
                 const std::string& outline_style) {
  return symbol("fill", name, "SimpleFill",
                {{"color", colour},
                 {"style", "solid"},
                 {"outline_color", outline},
                 {"outline_style", outline_style},
                 {"outline_width", "0.5"},
                 {"outline_width_unit", "MM"},
                 {"joinstyle", "bevel"}});
}

std::string line(const std::string& name, const std::string& colour) {
  return symbol("line", name, "SimpleLine",
                {{"line_color", colour},
                 {"line_style", "solid"},
                 {"line_width", "0.4"},
                 {"line_width_unit", "MM"},
                 {"capstyle", "square"},
                 {"joinstyle", "bevel"}});
}

std::string marker(const std::string& name, const std::string& colour) {
  return symbol("marker", name, "SimpleMarker",
                {{"name", "circle"},
                 {"color", colour},
                 {"outline_style", "no"},
                 {"size", "0.8"},
                 {"size_unit", "MM"}});
}

std::string document(const std::string& renderer) {
  return "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
         R"(<qgis version="3.22.0" styleCategories="Symbology">)" +
         renderer + "</qgis>\n";
}

struct Category {
  std::string value;  // empty: every other value
  std::string label;
  std::string symbol;
};

std::string categorized(const std::string& field, const std::vector<Category>& categories) {
  std::string entries, symbols;
  for (std::size_t i = 0; i < categories.size(); ++i) {
    entries += fmt::format(R"(<category value="{}" label="{}" symbol="{}" render="true"/>)",
                           categories[i].value, categories[i].label, i);
    symbols += categories[i].symbol;
  }
  return document(fmt::format(
      R"(<renderer-v2 type="categorizedSymbol" attr="{}" symbollevels="0" enableorderby="0" )"
      R"(forceraster="0"><categories>{}</categories><symbols>{}</symbols><rotation/><sizescale/>)"
      "</renderer-v2>",
      field, entries, symbols));
}

// A zone whose distance is only a lower bound has a dashed edge: the ground may go further.
std::string zone(const std::string& colour, const std::string& outline) {
  return categorized(
      "leda_distance_is",
      {{"measured", "to where it came to rest", fill("0", colour, outline, "solid")},
       {"lower-bound", "at least; it was still moving", fill("1", colour, outline, "dash")},
       {"", "", fill("2", colour, outline, "solid")}});
}

}  // namespace

std::string qgis_style(const std::string& layer) {
  if (layer == "release_zones") return zone("215,48,39,110", "165,0,38,255");
  if (layer == "runout_zones") return zone("253,174,97,110", "230,120,20,255");
  if (layer == "sections") {
    return categorized("leda_status",
                       {{"at-rest", "slid, at rest", line("0", "165,0,38,255")},
                        {"time-limit", "still moving", line("1", "215,48,39,255")},
                        {"left-domain", "left the model", line("2", "215,48,39,255")},
                        {"stable", "stable", line("3", "26,150,65,255")},
                        {"", "without a result", line("4", "120,120,120,255")}});
  }
  if (layer == "profiles") {
    return categorized("stage", {{"before", "ground before", marker("0", "90,90,90,255")},
                                 {"after", "ground after", marker("1", "69,117,180,255")}});
  }
  return "";
}

}  // namespace leda::profiles
