#include "server/jobs/map_region.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <variant>

#include "profiles/build_section.hpp"
#include "profiles/dem.hpp"
#include "profiles/lay_out_sections.hpp"
#include "profiles/place_result.hpp"
#include "profiles/trace_profile.hpp"
#include "profiles/zonation.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/screening_document.hpp"
#include "server/jobs/job_limits.hpp"
#include "server/jobs/region_faults.hpp"
#include "server/jobs/region_members.hpp"
#include "server/jobs/request_pointers.hpp"
#include "server/layers/job_ensemble.hpp"
#include "server/operate/problem.hpp"
#include "solver/screening/decide.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

using db::SectionRecord;
using db::SectionState;

SectionRecord record_of(const Profile& profile, const profiles::LaidSection& laid) {
  SectionRecord record;
  record.name = laid.name;
  record.line = laid.line;
  record.order = laid.order;
  record.trace = profile.trace;
  record.ground = profile.ground;
  record.crest = profile.bank.crest;
  record.toe = profile.bank.toe;
  record.warnings = profile.warnings;
  return record;
}

SectionRecord record_of(const LeftOut& left_out, const profiles::LaidSection& laid) {
  SectionRecord record;
  record.name = laid.name;
  record.line = laid.line;
  record.order = laid.order;
  record.trace = left_out.trace;
  record.state = SectionState::left_out;
  record.reason = left_out.reason;
  return record;
}

class Region final : public Work {
 public:
  Region(std::string text, RegionRequest request, db::RasterRecord raster,
         std::filesystem::path dem_file, const db::Store& store)
      : text_(std::move(text)),
        request_(std::move(request)),
        raster_(std::move(raster)),
        dem_file_(std::move(dem_file)) {
    if (request_.ensemble) members_.emplace(request_, store);
  }

  std::vector<SectionRecord> plan() const override {
    const auto dem = open_dem();
    const auto document = nlohmann::json::parse(text_);
    std::vector<SectionRecord> sections;
    RegionFaults of_named, of_laid;  // faults of named lines, and of sections laid along a line
    bool any_fits = false;
    for (const auto& laid : lay_out(dem, document)) {
      const auto cut = profiles::trace_profile(laid, dem);
      if (const auto* profile = std::get_if<Profile>(&cut)) {
        auto record = record_of(*profile, laid);
        const auto faults = check(*profile, record.warnings, document);
        any_fits = any_fits || faults.empty();
        auto& told = laid.line < 0 ? of_named : of_laid;
        for (const auto& fault : faults) told.add(fault.pointer, fault.message, laid.name);
        sections.push_back(std::move(record));
        if (!faults.empty()) leave_out(sections.back(), faults);
      } else {
        sections.push_back(record_of(std::get<LeftOut>(cut), laid));
      }
      sections.back().ordinal = static_cast<int>(sections.size()) - 1;
    }
    refuse(of_named);
    // What no section escapes is a fault of the request; what some do is a reason to leave those
    // out and go on: real ground has banks that a soil or a trigger does not fit.
    if (!any_fits) refuse(of_laid);
    if (members_) {
      refuse_members(members_->check(sections, document));
      add_members(sections, members_->plan());
    }
    return sections;
  }

  void planned() override {
    text_ = {};
    request_.layout = {};
  }

  std::string raster() const override { return raster_.id; }

  std::vector<std::string> warnings() const override { return raster_.warnings; }

  std::string case_file(const SectionRecord& section) const override {
    return to_document(case_of(section)).dump(2) + "\n";
  }

  RunSize size(const SectionRecord& section) const override {
    const auto built = profiles::build_section(profile_of(section), request_.soil);
    RunSettings settings = request_.settings;
    if (members_) {
      settings.resolution = resolution_of(section, settings.resolution, members_->plan().check);
    }
    if (section.member) settings.output = Output{};
    return run_size(built.section, settings);
  }

  std::optional<Screened> screen(const SectionRecord& section) const override {
    CaseFile of;
    try {
      of = case_of(section);
    } catch (const std::runtime_error&) {
      return std::nullopt;  // told when it is to be started
    }
    const auto result = solver::screen_quickly(of.section, of.settings);
    Screened screened;
    screened.document = to_document(result).dump();
    screened.skip = request_.skip_stable && result.decision == solver::Decision::stable;
    if (!result.reasons.empty()) screened.reason = result.reasons.front();
    return screened;
  }

  bool may_be_spared(const SectionRecord& section) const override {
    return section.member && is_beyond_first_look(section, members_->plan());
  }

  std::string not_needed(const SectionRecord& section) const override {
    return section.member ? members_->not_needed(section) : "";
  }

  PlacedResult place(const SectionRecord& section, const SectionResult& result) const override {
    return profiles::place_result(profile_of(section), section.line, section.order, result,
                                  result.case_sha256 + " leda " + result.version);
  }

  std::vector<Zone> zones(const std::vector<SectionRecord>& sections) const override {
    std::vector<PlacedResult> placed;
    placed.reserve(sections.size());
    for (const auto& section : sections) placed.push_back(on_the_map(section));
    profiles::ZonationOptions options;
    options.metres_per_unit = open_dem().info().metres_per_unit;
    auto zones = profiles::make_zones(placed, options);
    if (members_) std::ranges::move(members_->zones(sections, options), std::back_inserter(zones));
    return zones;
  }

 private:
  /// @throws std::runtime_error where a member draws what no section can have
  CaseFile case_of(const SectionRecord& section) const {
    if (section.member) {
      auto member = members_->case_of(section);
      if (member) return std::move(*member.value);
      const Fault& fault = member.faults.front();
      throw std::runtime_error("it draws what no section can have: " + fault.pointer + " " +
                               fault.message);
    }
    return {profiles::build_section(profile_of(section), request_.soil).section, request_.settings};
  }

  profiles::Dem open_dem() const {
    profiles::DemOptions options;
    options.missing_m = raster_.undeclared_fill_m;
    return profiles::Dem::open(dem_file_, options);
  }

  std::vector<profiles::LaidSection> lay_out(const profiles::Dem& dem,
                                             const nlohmann::json& document) const {
    profiles::LayoutLimits limits;
    limits.most_sections = JobLimits{}.sections;
    auto layout = profiles::lay_out_sections(request_.layout, dem, limits);
    for (auto& fault : layout.faults) fault.pointer = layout_pointer(document, fault.pointer);
    if (!layout.faults.empty()) {
      throw Problem(Failure::invalid_request, "the sections cannot be laid out on the DEM",
                    layout.faults);
    }
    return std::move(layout.sections);
  }

  /// Faults: soil that does not fit the profile, or a model that is too large. Without faults,
  /// what is odd is added to the warnings.
  std::vector<Fault> check(const Profile& profile, std::vector<std::string>& warnings,
                           const nlohmann::json& document) const {
    const auto built = profiles::build_section(profile, request_.soil);
    auto faults = faults_of(built, request_.settings, document);
    if (faults.empty()) {
      add_new(warnings, built.warnings);
      add_new(warnings, warnings_of(built.section, request_.settings));
    }
    return faults;
  }

  static void refuse(const RegionFaults& faults) {
    if (faults.none()) return;
    throw Problem(Failure::invalid_request, "the sections cannot be simulated", faults.list());
  }

  static void refuse_members(const std::vector<Fault>& faults) {
    if (faults.empty()) return;
    throw Problem(Failure::invalid_request, "members of the ensemble cannot be simulated", faults);
  }

  static void leave_out(SectionRecord& section, const std::vector<Fault>& faults) {
    section.state = SectionState::left_out;
    for (const auto& fault : faults) {
      if (!section.reason.empty()) section.reason += "; ";
      section.reason += fault.pointer + " " + fault.message;
    }
  }

  static PlacedResult on_the_map(const SectionRecord& section) {
    if (section.placed) return *section.placed;
    if (section.state == SectionState::stable) {
      return profiles::place_stable(profile_of(section), section.line, section.order, "screening");
    }
    return profiles::place_unknown(section.name, section.trace, section.line, section.order,
                                   section.reason);
  }

  std::string text_;  ///< of the request: faults point into what the user wrote
  RegionRequest request_;
  db::RasterRecord raster_;
  std::filesystem::path dem_file_;
  mutable std::optional<RegionMembers> members_;  ///< its looks are of the dispatcher's thread
};

}  // namespace

std::unique_ptr<Work> open_region(const std::string& request, const Library& library) {
  auto parsed = parse_region_request(request, DemNaming::registered_only);
  if (!parsed) {
    throw Problem(Failure::invalid_request, "the request cannot be understood", parsed.faults);
  }
  const std::string& wanted = library.raster.empty() ? parsed.value->dem : library.raster;
  const auto raster = library.store.raster(wanted);
  if (raster && !raster->removed.empty()) {
    throw Problem(Failure::invalid_request, "the DEM was removed",
                  {{"/inputs/dem", "raster '" + wanted + "' was removed on " + raster->removed +
                                       ": register it again"}});
  }
  if (!raster) {
    throw Problem(
        Failure::invalid_request, "the DEM is not registered",
        {{"/inputs/dem", "there is no raster '" + wanted +
                             "': register it with POST /rasters?name=, see GET /rasters"}});
  }
  return std::make_unique<Region>(request, std::move(*parsed.value), *raster,
                                  library.data.root() / raster->file, library.store);
}

}  // namespace leda::server
