#pragma once
// HDF5 identifiers that close themselves, and its errors as exceptions. Private to db/.

#include <hdf5.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

namespace leda::db {

/// Before the first use in a thread. HDF5 prints its error stack by itself otherwise; the setting
/// is the thread's own. When the process exits it would close once more what could not be closed,
/// and crashes over a file that a full disk left unwritten: what is open is closed here, not there.
inline void keep_hdf5_quiet() {
  static const herr_t not_at_exit = H5dont_atexit();
  static_cast<void>(not_at_exit);  // refused where GDAL has begun HDF5 before: a server writes none
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// The innermost message of HDF5's error stack, which names the cause.
inline std::string hdf5_cause() {
  std::string cause = "unknown cause";
  const auto take = [](unsigned depth, const H5E_error2_t* error, void* out) -> herr_t {
    if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(out) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &cause);
  return cause;
}

/// Passes on what an HDF5 call answered. Throws std::runtime_error naming the file and the cause.
template <class Answer>
Answer hdf5(Answer answer, const std::filesystem::path& file, const std::string& what) {
  if (answer < 0) throw std::runtime_error(file.string() + ": " + what + ": " + hdf5_cause());
  return answer;
}

class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close how) : id_(id), close_(how) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() { close(); }

  operator hid_t() const { return id_; }  // NOLINT: it stands for the identifier everywhere

  /// @return negative where HDF5 fails
  herr_t close() {
    if (id_ < 0) return 0;
    return close_(std::exchange(id_, H5I_INVALID_HID));
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

}  // namespace leda::db
