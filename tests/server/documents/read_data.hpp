#pragma once

#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/section/validate.hpp"

namespace leda::test {

inline std::string read_case(const std::string& name) {
  std::ifstream in(std::string(LEDA_CASES) + "/" + name);
  if (!in) throw std::runtime_error(name + " is missing from tests/data/cases");
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::multiset<std::string> pointers(const std::vector<Fault>& faults) {
  std::multiset<std::string> found;
  for (const Fault& f : faults) found.insert(f.pointer);
  return found;
}

inline std::string text(const std::vector<Fault>& faults) {
  std::string all;
  for (const Fault& f : faults) all += f.pointer + ": " + f.message + "\n";
  return all;
}

}  // namespace leda::test
