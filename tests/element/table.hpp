#pragma once
// A published table: rows of a CSV in tests/data, by column name.

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace leda::test {

class Row {
 public:
  const std::string& text(const std::string& column) const { return cells_.at(column); }
  double operator[](const std::string& column) const { return std::stod(cells_.at(column)); }
  void set(const std::string& column, const std::string& cell) { cells_[column] = cell; }

 private:
  std::map<std::string, std::string> cells_;
};

/// Throws where the file is missing or empty: a table that is not there must not pass a test.
inline std::vector<Row> table(const std::string& name) {
  std::ifstream in(std::string(LEDA_TEST_DATA) + "/" + name);
  std::vector<std::string> header;
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> cells;
    std::stringstream parts(line);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    if (header.empty()) {
      header = cells;
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < header.size(); ++i) row.set(header[i], cells.at(i));
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error("no rows in " + name);
  return rows;
}

}  // namespace leda::test
