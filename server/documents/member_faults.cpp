#include "server/documents/member_faults.hpp"

#include <fmt/format.h>

#include <utility>

namespace leda::server {

MemberFaults::MemberFaults(const UncertainDocument& document, std::string at)
    : document_(document), at_(std::move(at)) {}

void MemberFaults::add(const std::string& member, bool finer, const std::vector<double>& inputs,
                       const Fault& fault) {
  const auto input = document_.input_at(fault.pointer);
  std::string place = at_;
  if (input) place = fmt::format("{}/inputs/{}/distribution", at_, *input);
  if (finer) place = at_ + "/check/cell_m";
  Told& told = by_place_[place];
  if (told.count++ > 0) return;
  const std::string what =
      input ? "draws " + show(inputs[*input]) + ", with which " : "cannot be run: ";
  told.text = fmt::format("{} {}{} {}", member, what, fault.pointer, fault.message);
}

void MemberFaults::tell(FaultList& faults) const {
  for (const auto& [place, told] : by_place_) {
    const std::string more =
        told.count == 1 ? "" : fmt::format(" (and {} more like it)", told.count - 1);
    faults.add(place, told.text + more);
  }
}

}  // namespace leda::server
