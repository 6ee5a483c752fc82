#pragma once
// Faults of the sections of a region.

#include <map>
#include <string>
#include <vector>

#include "solver/section/validate.hpp"

namespace leda::server {

/// The same fault in a thousand sections is told once, with their number.
class RegionFaults {
 public:
  void add(const std::string& pointer, const std::string& message, const std::string& section) {
    Told& told = by_place_[pointer + "\n" + message];
    if (told.count++ == 0) {
      told.fault = {pointer, message};
      told.first_section = section;
    }
  }

  std::vector<Fault> list() const {
    std::vector<Fault> faults;
    for (const auto& [place, told] : by_place_) {
      Fault fault = told.fault;
      if (!told.first_section.empty()) {
        fault.message += " (section " + told.first_section;
        if (told.count > 1) fault.message += " and " + std::to_string(told.count - 1) + " more";
        fault.message += ")";
      }
      faults.push_back(fault);
    }
    return faults;
  }

  bool none() const { return by_place_.empty(); }

 private:
  struct Told {
    Fault fault;
    std::string first_section;
    int count = 0;
  };
  std::map<std::string, Told> by_place_;
};

}  // namespace leda::server
