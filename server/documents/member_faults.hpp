#pragma once
// What is wrong with the members of an ensemble: told once a place, of the first member, with how
// many more are like it.

#include <map>
#include <string>
#include <vector>

#include "server/documents/uncertain_document.hpp"

namespace leda::server {

class MemberFaults {
 public:
  /// @param at of the ensemble: "/inputs/ensemble"
  MemberFaults(const UncertainDocument& document, std::string at);

  /// @param member its name
  /// @param inputs as drawn for it
  /// @param fault whose pointer leads into the document that the inputs' paths lead into
  void add(const std::string& member, bool finer, const std::vector<double>& inputs,
           const Fault& fault);

  /// At the distribution of the input that makes the fault, at the finer cell, or at the ensemble.
  void tell(FaultList& faults) const;

 private:
  struct Told {
    std::string text;
    std::size_t count = 0;
  };

  const UncertainDocument& document_;
  std::string at_;
  std::map<std::string, Told> by_place_;
};

}  // namespace leda::server
