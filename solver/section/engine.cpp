#include "solver/section/engine.hpp"

namespace leda {

const char* to_string(Precision precision) {
  return precision == Precision::single_precision ? "single" : "double";
}

std::optional<Precision> precision_from(const std::string& text) {
  for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
    if (text == to_string(precision)) return precision;
  }
  return std::nullopt;
}

}  // namespace leda
