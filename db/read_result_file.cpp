// Reading fields.h5 back. The file may come from a worker that was killed: nothing is believed.

#include <algorithm>
#include <array>
#include <cstdint>

#include "db/hdf5_handle.hpp"
#include "db/result_file.hpp"
#include "solver/section/frame.hpp"
#include "solver/section/validate.hpp"

namespace leda::db {

namespace {

constexpr hsize_t most_frames = 1'000'000;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : path_(file) {
    keep_hdf5_quiet();
    if (!std::filesystem::is_regular_file(file)) fail("no such file");
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access, true, true);
    const std::string name = file.string();
    file_ = Hdf5Handle(check(H5Fopen(name.c_str(), H5F_ACC_RDONLY, access),
                             "not a whole HDF5 file (truncated, damaged or of another kind)"),
                       H5Fclose);
    const auto format = strings("format");
    if (format != std::vector<std::string>{"leda-fields-1"})
      fail("not a fields.h5 that this Leda reads: attribute format is \"" +
           (format.empty() ? "" : format.front()) + "\", should be \"leda-fields-1\"");
  }

  std::vector<std::string> strings(const char* name) const;
  std::vector<Frame> frames() const;
  FramePart part(const FrameWindow& window) const;

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(path_.string() + ": " + what);
  }
  template <class Answer>
  Answer check(Answer answer, const std::string& what) const {
    return hdf5(answer, path_, what);
  }
  Hdf5Handle dataset(const char* name) const {
    return {check(H5Dopen2(file_, name, H5P_DEFAULT), std::string("dataset ") + name), H5Dclose};
  }
  template <int Rank>
  std::array<hsize_t, Rank> extent(hid_t dataset, const char* name) const;
  template <class Value>
  std::vector<Value> series(const char* name, hid_t memory_type, hsize_t count) const;
  std::vector<double> times() const;
  /// @param first of the file's frames, that frames[0] is
  template <class Value>
  void table(const char* name, hid_t memory_type, const std::vector<std::int64_t>& counts,
             std::size_t first, std::vector<Frame>& frames,
             std::vector<Value> Frame::*values) const;

  std::filesystem::path path_;
  Hdf5Handle file_;
};

std::vector<std::string> Reader::strings(const char* name) const {
  const Hdf5Handle attribute(
      check(H5Aopen(file_, name, H5P_DEFAULT), std::string("attribute ") + name), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || count < 0)
    fail(std::string("attribute ") + name + " should be text of fixed length");
  const std::size_t width = H5Tget_size(type);
  std::vector<char> bytes(std::max<std::size_t>(1, width * static_cast<std::size_t>(count)));
  check(H5Aread(attribute, type, bytes.data()), std::string("attribute ") + name);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(i * width);
    const auto end = begin + static_cast<std::ptrdiff_t>(width);
    words.emplace_back(begin, std::find(begin, end, '\0'));
  }
  return words;
}

template <int Rank>
std::array<hsize_t, Rank> Reader::extent(hid_t dataset, const char* name) const {
  const Hdf5Handle space(check(H5Dget_space(dataset), name), H5Sclose);
  std::array<hsize_t, Rank> size{};
  if (H5Sget_simple_extent_ndims(space) != Rank)
    fail(std::string("dataset ") + name + " should have " + std::to_string(Rank) + " dimensions");
  H5Sget_simple_extent_dims(space, size.data(), nullptr);
  return size;
}

template <class Value>
std::vector<Value> Reader::series(const char* name, hid_t memory_type, hsize_t count) const {
  const Hdf5Handle data = dataset(name);
  if (extent<1>(data, name)[0] != count)
    fail(std::string("dataset ") + name + " should have " + std::to_string(count) + " entries");
  std::vector<Value> values(count);
  check(H5Dread(data, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        std::string("dataset ") + name);
  return values;
}

template <class Value>
void Reader::table(const char* name, hid_t memory_type, const std::vector<std::int64_t>& counts,
                   std::size_t first, std::vector<Frame>& frames,
                   std::vector<Value> Frame::*values) const {
  const Hdf5Handle data = dataset(name);
  const auto size = extent<2>(data, name);
  const Hdf5Handle source(check(H5Dget_space(data), name), H5Sclose);
  for (std::size_t i = first; i < first + frames.size(); ++i) {
    const auto count = static_cast<hsize_t>(counts[i]);
    if (counts[i] < 0 || counts[i] > most_particles || count > size[1] || i >= size[0])
      fail(std::string("dataset ") + name + " does not hold the " + std::to_string(counts[i]) +
           " particles of frame " + std::to_string(i));
    auto& row_values = frames[i - first].*values;
    row_values.resize(count);
    if (count == 0) continue;
    const std::array<hsize_t, 2> start = {i, 0};
    const std::array<hsize_t, 2> row = {1, count};
    H5Sselect_hyperslab(source, H5S_SELECT_SET, start.data(), nullptr, row.data(), nullptr);
    const Hdf5Handle target(H5Screate_simple(1, &count, nullptr), H5Sclose);
    check(H5Dread(data, memory_type, target, source, H5P_DEFAULT, row_values.data()),
          std::string("dataset ") + name);
  }
}

std::vector<double> Reader::times() const {
  const Hdf5Handle time = dataset("time");
  const hsize_t count = extent<1>(time, "time")[0];
  if (count > most_frames) fail("dataset time claims " + std::to_string(count) + " frames");
  return series<double>("time", H5T_NATIVE_DOUBLE, count);
}

std::vector<Frame> Reader::frames() const {
  const auto all_times = times();
  const auto particles = series<std::int64_t>("particles", H5T_NATIVE_INT64, all_times.size());
  std::vector<Frame> all(all_times.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].time_s = all_times[i];
  for (const FrameField& field : frame_fields)
    table(field.name, H5T_NATIVE_FLOAT, particles, 0, all, field.values);
  table("material", H5T_NATIVE_INT32, particles, 0, all, &Frame::material);
  return all;
}

FramePart Reader::part(const FrameWindow& window) const {
  FramePart part;
  part.times_s = times();
  part.materials = strings("materials");
  const auto particles = series<std::int64_t>("particles", H5T_NATIVE_INT64, part.times_s.size());
  std::int64_t sum = 0;
  for (std::size_t i = window.first; i < particles.size() && part.frames.size() < window.count;
       ++i) {
    sum += std::max<std::int64_t>(particles[i], 0);
    if (!part.frames.empty() && sum > static_cast<std::int64_t>(window.most_particles)) break;
    part.frames.emplace_back().time_s = part.times_s[i];
  }
  for (const FrameField& field : frame_fields) {
    if (std::ranges::find(window.fields, field.name) == window.fields.end()) continue;
    table(field.name, H5T_NATIVE_FLOAT, particles, window.first, part.frames, field.values);
  }
  if (window.material)
    table("material", H5T_NATIVE_INT32, particles, window.first, part.frames, &Frame::material);
  return part;
}

}  // namespace

ResultFileOrigin read_result_file_origin(const std::filesystem::path& file) {
  const Reader reader(file);
  const auto one = [&](const char* name) {
    const auto words = reader.strings(name);
    return words.empty() ? std::string() : words.front();
  };
  return {reader.strings("materials"), one("case_sha256"), one("version")};
}

std::vector<Frame> read_result_file(const std::filesystem::path& file) {
  return Reader(file).frames();
}

FramePart read_frames(const std::filesystem::path& file, const FrameWindow& window) {
  return Reader(file).part(window);
}

}  // namespace leda::db
