#pragma once
// The settings of a study as a document asks for them: a grid of the values on every axis, and
// what is asked for beside it.

#include <array>
#include <string>
#include <vector>

#include "server/documents/object_reader.hpp"
#include "solver/study/study.hpp"

namespace leda::server {

struct AskedSetting {
  solver::RepeatedSetting repeated;
  /// By axis, where the document asks for the value; empty: it is the case's own.
  std::array<std::string, solver::study_axes.size()> at;
};

/// Reads the lists of the axes, seeds and also; values at fault are in no setting.
/// @param own what settings take on axes that the document may leave out
std::vector<AskedSetting> read_study_grid(ObjectReader& reader, const solver::StudySetting& own,
                                          FaultList& faults);

/// The place in the study of a fault that validate() finds in a case at this setting; empty where
/// the case itself is at fault.
std::string place_of(const AskedSetting& asked, const std::string& fault_of_case);

}  // namespace leda::server
