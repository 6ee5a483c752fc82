#pragma once
// What computes a run: so that two results of different engines can be told apart.

#include <optional>
#include <string>

namespace leda {

enum class Precision { single_precision, double_precision };

const char* to_string(Precision precision);  ///< "single" or "double"
std::optional<Precision> precision_from(const std::string& text);

/// Of the moving stage; a run that ends before it names the quiet stages' double precision.
struct Engine {
  Precision precision = Precision::double_precision;
  std::string instructions;        ///< vector instructions of the processor: "avx2", "avx3", "sse4"
  double time_step_factor = 0;     ///< of h / c_p, as used: may be less than what was asked for
  bool averaged_dilation = false;  ///< B-bar: dilation and pressure are means over cells

  bool operator==(const Engine&) const = default;
};

}  // namespace leda
