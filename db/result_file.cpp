#include "db/result_file.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "db/hdf5_handle.hpp"
#include "disk/new_file.hpp"
#include "solver/section/frame.hpp"

namespace leda::db {

namespace {

// A chunk is one frame's worth of at most this many particles: 256 kB before compression.
constexpr hsize_t most_particles_a_chunk = 65536;
constexpr int deflate_level = 1;

Hdf5Handle access_properties() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // The 1.10 format checks its own structure, and marks a file that was not closed.
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  // Cluster file systems without locks are no reason to fail: a run has one writer.
  H5Pset_file_locking(access, true, true);
  // A chunk is written once and whole: a cache of chunks would hold up to 1 MB of each field.
  H5Pset_cache(access, 0, 521, 0, 0);
  return access;
}

// Without the clock's time in it, the same frames give the same bytes.
Hdf5Handle timeless(hid_t kind) {
  Hdf5Handle creation(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  return creation;
}

}  // namespace

struct ResultFileWriter::File {
  explicit File(const std::filesystem::path& target) : place(target) {}

  disk::NewFile place;
  Hdf5Handle file;
  Hdf5Handle time, particles, material;
  std::vector<Hdf5Handle> fields;
  hsize_t frames = 0;
  hsize_t columns = 0;  // the most particles of any frame so far

  template <class Answer>
  Answer check(Answer answer, const std::string& what) const {
    return hdf5(answer, place.file(), what);
  }

  void write_strings(const char* name, const std::vector<std::string>& words, bool scalar) const;
  void describe(hid_t dataset, const char* unit, const char* meaning) const;
  Hdf5Handle make_series(const char* name, hid_t type) const;
  Hdf5Handle make_table(const char* name, hid_t type, hid_t memory_type, const void* fill,
                        hsize_t chunk) const;
  void make_datasets(hsize_t particles_of_first_frame);
  void write_row(hid_t dataset, hid_t memory_type, const void* values, hsize_t count) const;
  void write_value(hid_t dataset, hid_t memory_type, const void* value) const;

 private:
  void write_attribute(hid_t object, const char* name, const std::vector<std::string>& words,
                       bool scalar) const;
};

void ResultFileWriter::File::write_attribute(hid_t object, const char* name,
                                             const std::vector<std::string>& words,
                                             bool scalar) const {
  std::size_t width = 1;
  for (const std::string& word : words) width = std::max(width, word.size());
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, width);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  const hsize_t count = words.size();
  const Hdf5Handle space(scalar ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr),
                         H5Sclose);
  std::vector<char> bytes(std::max<std::size_t>(1, width * words.size()), '\0');
  for (std::size_t i = 0; i < words.size(); ++i)
    std::copy(words[i].begin(), words[i].end(),
              bytes.begin() + static_cast<std::ptrdiff_t>(i * width));
  const Hdf5Handle attribute(
      check(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), name), H5Aclose);
  check(H5Awrite(attribute, type, bytes.data()), name);
}

void ResultFileWriter::File::write_strings(const char* name, const std::vector<std::string>& words,
                                           bool scalar) const {
  write_attribute(file, name, words, scalar);
}

void ResultFileWriter::File::describe(hid_t dataset, const char* unit, const char* meaning) const {
  write_attribute(dataset, "unit", {unit}, true);
  write_attribute(dataset, "meaning", {meaning}, true);
}

Hdf5Handle ResultFileWriter::File::make_series(const char* name, hid_t type) const {
  const hsize_t none = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const hsize_t chunk = 256;
  const Hdf5Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose);
  const Hdf5Handle creation = timeless(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 1, &chunk);
  H5Pset_fletcher32(creation);
  return {check(H5Dcreate2(file, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT), name),
          H5Dclose};
}

Hdf5Handle ResultFileWriter::File::make_table(const char* name, hid_t type, hid_t memory_type,
                                              const void* fill, hsize_t chunk_particles) const {
  const std::array<hsize_t, 2> none = {0, 0};
  const std::array<hsize_t, 2> unlimited = {H5S_UNLIMITED, H5S_UNLIMITED};
  const std::array<hsize_t, 2> chunk = {1, chunk_particles};
  const Hdf5Handle space(H5Screate_simple(2, none.data(), unlimited.data()), H5Sclose);
  const Hdf5Handle creation = timeless(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 2, chunk.data());
  H5Pset_fill_value(creation, memory_type, fill);
  H5Pset_shuffle(creation);
  H5Pset_deflate(creation, deflate_level);
  H5Pset_fletcher32(creation);
  return {check(H5Dcreate2(file, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT), name),
          H5Dclose};
}

void ResultFileWriter::File::make_datasets(hsize_t particles_of_first_frame) {
  time = make_series("time", H5T_IEEE_F64LE);
  describe(time, "s", "simulated time of a frame");
  particles = make_series("particles", H5T_STD_I64LE);
  describe(particles, "1", "particles of a frame; entries of its row beyond them are fill");
  const hsize_t chunk = std::clamp<hsize_t>(particles_of_first_frame, 1, most_particles_a_chunk);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const FrameField& field : frame_fields) {
    fields.push_back(make_table(field.name, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, &nan, chunk));
    describe(fields.back(), field.unit, field.meaning);
  }
  const std::int32_t none = -1;
  material = make_table("material", H5T_STD_I32LE, H5T_NATIVE_INT32, &none, chunk);
  describe(material, "1", "index into the attribute materials of the file");
}

void ResultFileWriter::File::write_row(hid_t dataset, hid_t memory_type, const void* values,
                                       hsize_t count) const {
  const std::array<hsize_t, 2> extent = {frames + 1, columns};
  check(H5Dset_extent(dataset, extent.data()), "extend");
  if (count == 0) return;
  const std::array<hsize_t, 2> start = {frames, 0};
  const std::array<hsize_t, 2> size = {1, count};
  const Hdf5Handle target(check(H5Dget_space(dataset), "space"), H5Sclose);
  H5Sselect_hyperslab(target, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr);
  const Hdf5Handle source(H5Screate_simple(1, &count, nullptr), H5Sclose);
  check(H5Dwrite(dataset, memory_type, source, target, H5P_DEFAULT, values), "write");
}

void ResultFileWriter::File::write_value(hid_t dataset, hid_t memory_type,
                                         const void* value) const {
  const hsize_t extent = frames + 1;
  const hsize_t one = 1;
  check(H5Dset_extent(dataset, &extent), "extend");
  const Hdf5Handle target(check(H5Dget_space(dataset), "space"), H5Sclose);
  H5Sselect_hyperslab(target, H5S_SELECT_SET, &frames, nullptr, &one, nullptr);
  const Hdf5Handle source(H5Screate_simple(1, &one, nullptr), H5Sclose);
  check(H5Dwrite(dataset, memory_type, source, target, H5P_DEFAULT, value), "write");
}

ResultFileWriter::ResultFileWriter(const std::filesystem::path& file,
                                   const std::vector<std::string>& materials,
                                   const std::string& case_sha256, const std::string& version)
    : file_(std::make_unique<File>(file)) {
  keep_hdf5_quiet();
  const Hdf5Handle access = access_properties(), creation = timeless(H5P_FILE_CREATE);
  const std::string part = file_->place.part().string();
  file_->file = Hdf5Handle(
      file_->check(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, creation, access), "create"), H5Fclose);
  file_->write_strings("format", {"leda-fields-1"}, true);
  file_->write_strings("case_sha256", {case_sha256}, true);
  file_->write_strings("version", {version}, true);
  file_->write_strings("materials", materials, false);
}

ResultFileWriter::~ResultFileWriter() = default;

void ResultFileWriter::append(const Frame& frame) {
  if (!file_) throw std::logic_error("ResultFileWriter: append after close");
  require_equal_lengths(frame);
  File& f = *file_;
  const hsize_t count = frame.x.size();
  if (f.frames == 0) f.make_datasets(count);
  f.columns = std::max(f.columns, count);
  for (std::size_t i = 0; i < frame_fields.size(); ++i)
    f.write_row(f.fields[i], H5T_NATIVE_FLOAT, (frame.*frame_fields[i].values).data(), count);
  f.write_row(f.material, H5T_NATIVE_INT32, frame.material.data(), count);
  const auto particles = static_cast<std::int64_t>(count);
  f.write_value(f.particles, H5T_NATIVE_INT64, &particles);
  f.write_value(f.time, H5T_NATIVE_DOUBLE, &frame.time_s);
  ++f.frames;
}

void ResultFileWriter::close() {
  if (!file_) return;
  File& f = *file_;
  if (f.frames == 0) f.make_datasets(0);
  for (Hdf5Handle& field : f.fields) f.check(field.close(), "close");
  for (Hdf5Handle* dataset : {&f.time, &f.particles, &f.material})
    f.check(dataset->close(), "close");
  f.check(f.file.close(), "close");
  f.place.keep();
  file_.reset();
}

}  // namespace leda::db
