#include "solver/element_test/lab_curve.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <string_view>

namespace leda::solver {
namespace {

constexpr std::size_t most_faults = 20;
constexpr std::size_t most_rows = 1'000'000;

struct Column {
  std::string_view name;
  double to_si;
};

constexpr std::array strain_columns{Column{"shear_strain", 1}, Column{"shear_strain_percent", .01}};
constexpr std::array stress_columns{Column{"shear_stress_kPa", 1000}};
constexpr std::array index_columns{Column{"remolding_index", 1},
                                   Column{"remolding_index_percent", .01}};
constexpr std::array energy_columns{Column{"normalized_energy", 1},
                                    Column{"normalized_energy_percent", .01}};

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const auto comma = line.find(',');
    std::string_view cell = line.substr(0, comma);
    const auto first = cell.find_first_not_of(" \t\r");
    const auto last = cell.find_last_not_of(" \t\r");
    cells.push_back(first == std::string_view::npos ? std::string_view{}
                                                    : cell.substr(first, last - first + 1));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

struct Found {
  std::size_t index;
  Column column;
};

template <class Columns>
std::optional<Found> find(const std::vector<std::string_view>& header, const Columns& columns) {
  for (const Column& column : columns) {
    const auto at = std::find(header.begin(), header.end(), column.name);
    if (at != header.end()) return Found{static_cast<std::size_t>(at - header.begin()), column};
  }
  return {};
}

/// Lines of a file that count, with their numbers.
class Reader {
 public:
  Reader(std::istream& in, std::vector<std::string>& faults) : in_(in), faults_(faults) {}

  /// Rows with another number of cells than the header hide values in the wrong column.
  void ask_for_cells(std::size_t number) { wanted_ = number; }

  bool next() {
    while (std::getline(in_, text_)) {
      ++line_;
      if (line_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
      if (!text_.empty() && text_[0] != '#' && text_ != "\r") return true;
    }
    return false;
  }
  std::vector<std::string_view> cells() const { return split(text_); }

  bool has_cells_of_header(const std::vector<std::string_view>& cells) {
    if (cells.size() == wanted_) return true;
    fault("has " + std::to_string(cells.size()) + " cells, the header " + std::to_string(wanted_) +
          (cells.size() > wanted_ ? ": decimals are written with a point, not a comma" : ""));
    return false;
  }

  void fault(const std::string& what) {
    if (faults_.size() < most_faults) {
      faults_.push_back("line " + std::to_string(line_) + ": " + what);
    }
  }

 private:
  std::istream& in_;
  std::vector<std::string>& faults_;
  std::string text_;
  std::size_t line_ = 0;
  std::size_t wanted_ = 0;
};

double cell_value(Reader& reader, const std::vector<std::string_view>& cells, const Found& found) {
  const std::string name(found.column.name);
  if (found.index >= cells.size()) {
    reader.fault(name + " is missing");
    return 0;
  }
  const auto value = number(cells[found.index]);
  if (!value) {
    reader.fault(name + " is \"" + std::string(cells[found.index].substr(0, 40)) +
                 "\", not a finite number");
  }
  return value.value_or(0) * found.column.to_si;
}

void read_rows(Reader& reader, const Found& x, const Found& y, std::vector<double>& xs,
               std::vector<double>& ys) {
  while (reader.next()) {
    const auto cells = reader.cells();
    if (!reader.has_cells_of_header(cells)) continue;
    xs.push_back(cell_value(reader, cells, x));
    ys.push_back(cell_value(reader, cells, y));
    if (xs.size() > 1 && xs.back() < xs[xs.size() - 2]) {
      reader.fault(std::string(x.column.name) + " goes back: rows must be in order");
    }
    if (ys.back() < 0) reader.fault(std::string(y.column.name) + " is negative");
    if (xs.size() > most_rows) return reader.fault("more than 1000000 rows");
  }
}

/// What a header may be that cannot be read though its names are there.
std::string hint_on(const std::vector<std::string_view>& header) {
  const std::string_view first = header[0];
  if (first.starts_with("\xFF\xFE") || first.starts_with("\xFE\xFF")) {
    return "the file is in UTF-16: save it as UTF-8";
  }
  for (const auto& [mark, name] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}}) {
    if (header.size() == 1 && first.find(mark) != std::string_view::npos) {
      return std::string("the columns are separated by ") + name +
             ": separate them by commas, and write decimals with a point";
    }
  }
  if (first.starts_with('"')) return "the names of the columns stand in quotes: leave those out";
  return "";
}

}  // namespace

LabFile read_lab_file(std::istream& in) {
  LabFile file;
  Reader reader(in, file.faults);
  if (!reader.next()) {
    reader.fault("the file is empty: expected a header such as shear_strain,shear_stress_kPa");
    return file;
  }
  const auto header = reader.cells();
  reader.ask_for_cells(header.size());
  const auto strain = find(header, strain_columns);
  const auto stress = find(header, stress_columns);
  const auto index = find(header, index_columns);
  const auto energy = find(header, energy_columns);
  if (strain && stress) {
    LabCurve& curve = file.stress_strain.emplace();
    read_rows(reader, *strain, *stress, curve.strain, curve.stress_Pa);
  } else if (index && energy) {
    EnergyCurve& curve = file.energy.emplace();
    read_rows(reader, *energy, *index, curve.normalized_energy, curve.remolding_index);
  } else if (const std::string hint = hint_on(header); !hint.empty()) {
    reader.fault(hint);
  } else {
    reader.fault(
        "the header must name shear_strain (or shear_strain_percent) and shear_stress_kPa, or "
        "normalized_energy and remolding_index (or either with _percent)");
  }
  return file;
}

}  // namespace leda::solver
