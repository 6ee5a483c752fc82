// Format: VTK User's Guide, "XML file formats"; raw appended data, each block led by its size in
// bytes as UInt64, offsets counted from the byte after the underscore.

#include "db/view_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "disk/new_file.hpp"
#include "solver/section/frame.hpp"

namespace leda::db {

namespace {

constexpr const char* byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

/// The XML head grows with the arrays; their bytes are gathered to follow it.
class AppendedData {
 public:
  template <class Value>
  void add(std::ostream& xml, const char* type, const std::string& name, int components,
           const std::vector<Value>& values) {
    xml << "        <DataArray type=\"" << type << "\" Name=\"" << name
        << "\" NumberOfComponents=\"" << components << "\" format=\"appended\" offset=\""
        << bytes_.size() << "\"/>\n";
    const std::uint64_t size = values.size() * sizeof(Value);
    put(&size, sizeof size);
    put(values.data(), size);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void put(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

std::vector<float> in_plane(const std::vector<float>& x, const std::vector<float>& z) {
  std::vector<float> triples;
  triples.reserve(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) triples.insert(triples.end(), {x[i], z[i], 0.0F});
  return triples;
}

void add_cells(std::ostream& xml, AppendedData& data, std::size_t particles) {
  constexpr std::uint8_t vtk_vertex = 1;
  std::vector<std::int64_t> numbers(particles);
  std::iota(numbers.begin(), numbers.end(), 0);
  xml << "      <Cells>\n";
  data.add(xml, "Int64", "connectivity", 1, numbers);
  std::iota(numbers.begin(), numbers.end(), 1);
  data.add(xml, "Int64", "offsets", 1, numbers);
  data.add(xml, "UInt8", "types", 1, std::vector<std::uint8_t>(particles, vtk_vertex));
  xml << "      </Cells>\n";
}

void add_point_data(std::ostream& xml, AppendedData& data, const Frame& frame) {
  const auto is_shown_otherwise = [](const FrameField& field) {
    return field.values == &Frame::x || field.values == &Frame::z ||
           field.values == &Frame::velocity_x || field.values == &Frame::velocity_z;
  };
  xml << "      <PointData Scalars=\"plastic_strain\" Vectors=\"velocity (m/s)\">\n";
  data.add(xml, "Float32", "velocity (m/s)", 3, in_plane(frame.velocity_x, frame.velocity_z));
  for (const FrameField& field : frame_fields) {
    if (is_shown_otherwise(field)) continue;
    const std::string unit = field.unit;
    const std::string name = unit == "1" ? field.name : field.name + (" (" + unit + ")");
    data.add(xml, "Float32", name, 1, frame.*field.values);
  }
  data.add(xml, "Int32", "material", 1, frame.material);
  xml << "      </PointData>\n";
}

std::string vtu(const Frame& frame) {
  const std::size_t particles = frame.x.size();
  std::ostringstream xml;
  AppendedData data;
  xml << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
      << byte_order << "\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n"
      << "    <Piece NumberOfPoints=\"" << particles << "\" NumberOfCells=\"" << particles
      << "\">\n";
  xml << "      <Points>\n";
  data.add(xml, "Float32", "Points", 3, in_plane(frame.x, frame.z));
  xml << "      </Points>\n";
  add_cells(xml, data, particles);
  add_point_data(xml, data, frame);
  xml << "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
  return xml.str() + data.bytes() + "\n  </AppendedData>\n</VTKFile>\n";
}

void write_whole(const std::filesystem::path& path, const std::string& bytes) {
  disk::NewFile file(path);
  std::ofstream out(file.part(), std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw std::runtime_error(path.string() + ": cannot be written");
  file.keep();
}

}  // namespace

ViewWriter::ViewWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

void ViewWriter::append(const Frame& frame) {
  require_equal_lengths(frame);
  std::filesystem::create_directories(folder_ / "view");
  const std::string name = fmt::format("view/frame-{:04}.vtu", entries_.size() + 1);
  write_whole(folder_ / name, vtu(frame));
  entries_.push_back({frame.time_s, name});
}

void ViewWriter::close() {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\""
      << byte_order << "\">\n  <Collection>\n";
  for (const Entry& entry : entries_)
    xml << "    <DataSet timestep=\"" << entry.time_s << "\" part=\"0\" file=\"" << entry.file
        << "\"/>\n";
  xml << "  </Collection>\n</VTKFile>\n";
  write_whole(folder_ / "view.pvd", xml.str());
}

}  // namespace leda::db
