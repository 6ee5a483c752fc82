#include "profiles/qgis_style.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>
#include <vector>

#include "profiles/probability_colours.hpp"

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

constexpr const char* head =
    "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
    R"(<qgis version="3.22.0" styleCategories="Symbology|Rendering">)";

// Opacity of the whole layer: zones that lie on each other do not hide the ground.
std::string document(const std::string& renderer, double opacity = 1) {
  return head + renderer + fmt::format("<layerOpacity>{}</layerOpacity></qgis>\n", opacity);
}

struct Category {
  std::string value;  // empty: every other value
  std::string label;
  std::string symbol;
};

std::string categorized(const std::string& field, const std::vector<Category>& categories,
                        double opacity = 1) {
  std::string entries, symbols;
  for (std::size_t i = 0; i < categories.size(); ++i) {
    entries += fmt::format(R"(<category value="{}" label="{}" symbol="{}" render="true"/>)",
                           categories[i].value, categories[i].label, i);
    symbols += categories[i].symbol;
  }
  return document(
      fmt::format(
          R"(<renderer-v2 type="categorizedSymbol" attr="{}" symbollevels="0" enableorderby="0" )"
          R"(forceraster="0"><categories>{}</categories><symbols>{}</symbols><rotation/><sizescale/>)"
          "</renderer-v2>",
          field, entries, symbols),
      opacity);
}

// A zone whose distance is only a lower bound has a dashed edge: the ground may go further.
std::string zone(const std::string& colour, const std::string& outline) {
  return categorized(
      "leda_distance_is",
      {{"measured", "to where it came to rest", fill("0", colour, outline, "solid")},
       {"lower-bound", "at least; it was still moving", fill("1", colour, outline, "dash")},
       {"", "", fill("2", colour, outline, "solid")}});
}

constexpr double over_hillshade = 0.6;  // the ground shows through

std::string colour_text(Colour c) { return fmt::format("{},{},{},255", c.red, c.green, c.blue); }

// The largest zone first, so that those inside it lie on top.
std::string probability_zones(const std::vector<Zone>& zones) {
  std::set<std::pair<ZoneKind, double>> seen;
  for (const Zone& zone : zones) {
    if (zone.probability) seen.emplace(zone.kind, zone.probability->exceedance);
  }
  std::vector<Category> categories;
  for (const auto& [kind, p] : seen) {
    const Colour colour = probability_colour(kind, p);
    categories.push_back({fmt::format("{} {}", to_string(kind), p),
                          fmt::format("{}, {:g} % of runs go beyond it", to_string(kind), 100 * p),
                          fill(fmt::format("{}", categories.size()), colour_text(colour),
                               colour_text({90, 90, 90}), "solid")});
  }
  return categorized("&quot;leda_kind&quot; || ' ' || &quot;leda_exceedance&quot;", categories,
                     over_hillshade);
}

}  // namespace

std::string qgis_raster_style(ZoneKind kind) {
  std::string items = R"(<item alpha="0" value="0" label="never reached" color="#ffffff"/>)";
  double from = 0;
  const auto add = [&](double to) {
    const Colour c = probability_colour(kind, to);
    items += fmt::format(
        R"(<item alpha="{}" value="{}" label="{:g} to {:g} %" color="#{:02x}{:02x}{:02x}"/>)",
        int(255 * over_hillshade), to < 1 ? fmt::format("{}", to) : "inf", 100 * from, 100 * to,
        c.red, c.green, c.blue);
    from = to;
  };
  for (const double to : probability_classes) add(to);
  add(1);
  return head +
         std::string(R"(<pipe><rasterrenderer type="singlebandpseudocolor" band="1" opacity="1" )"
                     R"(classificationMin="0" classificationMax="1"><rastershader>)"
                     R"(<colorrampshader colorRampType="DISCRETE" classificationMode="1" clip="0" )"
                     R"(minimumValue="0" maximumValue="1">)") +
         items + "</colorrampshader></rastershader></rasterrenderer></pipe></qgis>\n";
}

std::string qgis_style(const std::string& layer, const std::vector<Zone>& zones) {
  if (layer == "probability_zones") return probability_zones(zones);
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
