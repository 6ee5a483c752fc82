#include "solver/screening/decide.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "solver/screening/site_of_section.hpp"
#include "solver/screening/toe_cut.hpp"
#include "solver/screening/weak_ground.hpp"
#include "solver/section/shear_at_rest.hpp"

namespace leda::solver {
namespace {

std::string number(double value) {
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%.3g", value);
  return {text, std::size_t(std::max(length, 0))};
}

/// What the factors of safety of phi = 0 lose when every input is at its worst: they are
/// proportional to strength over unit weight.
double loss(const ScreeningMargins& margins) {
  return (1 - margins.strength) / (1 + margins.unit_weight);
}

bool softens_somewhere(const Section& section) {
  for (std::size_t list = 0; list < layer_lists(section); ++list) {
    for (const Layer& layer : layers_of(section, list)) {
      if (section.materials.at(layer.material).softening) return true;
    }
  }
  return false;
}

/// Height of the cut that the simulation would make if the section stood.
std::optional<double> asked_cut(const RunSettings& settings) {
  const auto* undrained = std::get_if<UndrainedTrigger>(&settings.trigger);
  if (!undrained) return std::nullopt;
  return undrained->then_toe_cut_m;
}

double required_toe_cut(const RunSettings& settings, const ScreeningMargins& margins) {
  return 1 + (asked_cut(settings) ? margins.asked_cut_factor : margins.factor);
}

double height_of_cut(const CrestAndToe& bank, const RunSettings& settings,
                     const ScreeningMargins& margins) {
  const double bank_height = bank.crest.z - bank.toe.z;
  if (const auto asked = asked_cut(settings)) return std::min(*asked, bank_height);
  return std::min(margins.toe_cut_m, margins.toe_cut_share * bank_height);
}

/// Looks at one section, a number at a time, and stops at the first that calls for a simulation.
class Decider {
 public:
  Decider(const Section& section, const RunSettings& settings, const ScreeningMargins& margins)
      : section_(section), settings_(settings), margins_(margins) {
    result_.required_intact = 1 + margins.factor;
    result_.required_toe_cut = required_toe_cut(settings, margins);
    result_.sensitive = softens_somewhere(section);
    result_.worst_at_rest = factor_at_rest(section, margins.water_table_m);
    if (result_.worst_at_rest) *result_.worst_at_rest *= loss(margins);
    if (const auto bank = bank_of(section); bank && bank->crest.z > bank->toe.z) {
      result_.toe_cut_m = height_of_cut(*bank, settings, margins);
      cut_ = ground_after_toe_cut(section.ground, *bank, result_.toe_cut_m);
    }
  }

  /// Ground of the toe-cut slope; empty where there is no bank.
  const Polyline& cut() const { return cut_; }

  void set_intact(const std::optional<double>& bishop) {
    result_.undrained.bishop = bishop;
    if (bishop) result_.worst_intact = *bishop * loss(margins_);
  }

  void set_toe_cut(const std::optional<double>& bishop) {
    result_.undrained_toe_cut.bishop = bishop;
    if (bishop) result_.worst_toe_cut = *bishop * loss(margins_);
  }

  ScreeningResult decide(bool everything) {
    if (std::holds_alternative<ExcavationTrigger>(settings_.trigger)) {
      to_simulate("an excavation is asked for: screening knows only the toe cut");
      if (!everything) return std::move(result_);
    }
    find_intact();
    if (!result_.sensitive) return judge_without_softening();
    if (result_.worst_at_rest && *result_.worst_at_rest < 1) {
      to_simulate("softening ground is overstressed at rest: strength over shear stress " +
                  number(*result_.worst_at_rest) + " < 1 for the worst inputs");
    }
    judge("intact", result_.worst_intact, result_.required_intact);
    if (!everything && !stands_) return std::move(result_);
    if (!cut_.empty()) {
      find_toe_cut();
      judge("with a toe cut of " + number(result_.toe_cut_m) + " m", result_.worst_toe_cut,
            result_.required_toe_cut);
    }
    return conclude();
  }

 private:
  void find_intact() {
    if (!result_.undrained.bishop) set_intact(undrained_bishop(section_, section_.ground));
  }

  void find_toe_cut() {
    if (!result_.undrained_toe_cut.bishop) set_toe_cut(undrained_bishop(section_, cut_));
  }

  void to_simulate(std::string why) {
    stands_ = false;
    result_.reasons.push_back(std::move(why));
  }

  /// Without softening nothing retrogresses; only a plain slip is left to look for.
  ScreeningResult judge_without_softening() {
    if (result_.worst_intact && *result_.worst_intact < 1) {
      to_simulate("nothing softens, but the undrained factor of safety is " +
                  number(*result_.worst_intact) + " < 1 for the worst inputs: it may slip");
    }
    if (stands_)
      result_.reasons.emplace_back("nothing sensitive: no material of the section softens");
    return conclude();
  }

  void judge(const std::string& which, const std::optional<double>& factor, double required) {
    if (!factor) {
      result_.reasons.push_back("no slip surface (" + which + "): the ground has no slope");
      return;
    }
    const std::string said = "undrained factor of safety, " + which + ", " + number(*factor);
    const std::string limit = number(required) + " for the worst inputs";
    if (*factor < required)
      to_simulate(said + " < " + limit);
    else
      result_.reasons.push_back(said + " >= " + limit);
  }

  ScreeningResult conclude() {
    result_.decision = stands_ ? Decision::stable : Decision::simulate;
    return std::move(result_);
  }

  const Section& section_;
  const RunSettings& settings_;
  const ScreeningMargins& margins_;
  Polyline cut_;
  bool stands_ = true;
  ScreeningResult result_;
};

/// What calls for a simulation goes first.
void put_deciding_reason_first(ScreeningResult& result) {
  if (result.decision == Decision::stable) return;
  std::stable_partition(
      result.reasons.begin(), result.reasons.end(), [](const std::string& reason) {
        return reason.find(" >= ") == std::string::npos && !reason.starts_with("no slip surface");
      });
}

ScreeningResult screen_completely(const Section& section, const RunSettings& settings,
                                  const ScreeningMargins& margins) {
  Decider decider(section, settings, margins);
  FactorsOfSafety undrained = factors_of_safety(section, section.ground, Drainage::undrained);
  decider.set_intact(undrained.bishop);
  FactorsOfSafety toe_cut;
  if (decider.cut().empty()) {
    toe_cut.why_not = "no bank to cut";
  } else {
    toe_cut = factors_of_safety(section, decider.cut(), Drainage::undrained);
    decider.set_toe_cut(toe_cut.bishop);
  }
  ScreeningResult result = decider.decide(true);
  result.undrained = std::move(undrained);
  result.undrained_toe_cut = std::move(toe_cut);
  result.drained = factors_of_safety(section, section.ground, Drainage::drained);
  put_deciding_reason_first(result);
  return result;
}

Analytics analytics_of(const Section& section) {
  if (const auto site = site_of(section)) return analyse(*site);
  Analytics analytics;
  analytics.missing["analytics"] = "the section has no bank";
  return analytics;
}

}  // namespace

const char* to_string(Decision decision) {
  return decision == Decision::stable ? "stable" : "simulate";
}

ScreeningResult screen(const Section& section, const RunSettings& settings,
                       const ScreeningMargins& margins) {
  const auto weak = weak_ground(section);
  ScreeningResult result = screen_completely(weak ? *weak : section, settings, margins);
  if (weak) result.reasons.push_back(told_of_weak_ground(section));
  result.analytics = analytics_of(section);
  return result;
}

ScreeningResult screen_quickly(const Section& section, const RunSettings& settings,
                               const ScreeningMargins& margins) {
  const auto weak = weak_ground(section);
  ScreeningResult result = Decider(weak ? *weak : section, settings, margins).decide(false);
  put_deciding_reason_first(result);
  if (weak) result.reasons.push_back(told_of_weak_ground(section));
  result.analytics = analytics_of(section);
  return result;
}

ScreeningResult screen_site(const Site& site, const ScreeningMargins& margins) {
  ScreeningResult result;
  if (site.slope_angle_deg) {
    result = screen_completely(section_of(site), {}, margins);
    result.drained.why_not = "a site has no drained strength: screen a case";
  } else {
    result.required_intact = 1 + margins.factor;
    result.required_toe_cut = required_toe_cut({}, margins);
    result.reasons = {"no slope angle: the factors of safety cannot be found"};
    result.drained.why_not = result.undrained.why_not = result.undrained_toe_cut.why_not =
        "no slope angle";
  }
  result.analytics = analyse(site);
  return result;
}

}  // namespace leda::solver
