#pragma once
// Named values as bytes, bit exact, and back. Each value carries its name and the size of its
// elements, so that bytes of a program that holds other values are told from those of this one.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace leda::solver {

/// Numbers and plain structs of numbers.
template <class T>
concept PlainBytes = std::is_trivially_copyable_v<T>;

/// Counts the bytes that a Writer will write, so that they are reserved once.
class Counter {
 public:
  template <PlainBytes T>
  void operator()(std::string_view name, const T&) {
    bytes_ += head(name) + sizeof(T);
  }
  template <PlainBytes T>
  void operator()(std::string_view name, const std::vector<T>& values) {
    bytes_ += head(name) + values.size() * sizeof(T);
  }
  void operator()(std::string_view name, const std::string& text) {
    bytes_ += head(name) + text.size();
  }
  std::size_t bytes() const { return bytes_; }

 private:
  static std::size_t head(std::string_view name) { return 3 * sizeof(std::uint64_t) + name.size(); }
  std::size_t bytes_ = 0;
};

class Writer {
 public:
  explicit Writer(std::size_t bytes) { bytes_.reserve(bytes); }
  template <PlainBytes T>
  void operator()(std::string_view name, const T& value) {
    put(name, sizeof(T), 1, &value);
  }
  template <PlainBytes T>
  void operator()(std::string_view name, const std::vector<T>& values) {
    put(name, sizeof(T), values.size(), values.data());
  }
  void operator()(std::string_view name, const std::string& text) {
    put(name, 1, text.size(), text.data());
  }
  std::string take() { return std::move(bytes_); }

 private:
  void number(std::uint64_t value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(std::string_view name, std::size_t size, std::size_t count, const void* from) {
    number(name.size());
    bytes_.append(name);
    number(size);
    number(count);
    if (count > 0) bytes_.append(static_cast<const char*>(from), size * count);
  }
  std::string bytes_;
};

/// A value under another name, of another size, or past the end leaves its target as it was; good()
/// is false from then on.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <PlainBytes T>
  void operator()(std::string_view name, T& value) {
    if (open(name, sizeof(T)) == 1 && good_)
      take(&value, sizeof(T));
    else
      good_ = false;
  }
  template <PlainBytes T>
  void operator()(std::string_view name, std::vector<T>& values) {
    const std::uint64_t count = open(name, sizeof(T));
    if (!good_) return;
    values.resize(count);
    take(values.data(), count * sizeof(T));
  }
  void operator()(std::string_view name, std::string& text) {
    const std::uint64_t count = open(name, 1);
    if (!good_) return;
    text.resize(count);
    take(text.data(), count);
  }
  bool good() const { return good_; }
  bool at_end() const { return good_ && bytes_.empty(); }

 private:
  std::uint64_t number() {
    std::uint64_t value = 0;
    take(&value, sizeof value);
    return value;
  }
  // Count of the elements that follow, which are there.
  std::uint64_t open(std::string_view name, std::size_t size) {
    const std::uint64_t length = number();
    good_ = good_ && length == name.size() && bytes_.starts_with(name);
    if (good_) bytes_.remove_prefix(length);
    good_ = number() == size && good_;
    const std::uint64_t count = number();
    good_ = good_ && count <= bytes_.size() / size;
    return good_ ? count : 0;
  }
  void take(void* to, std::size_t bytes) {
    good_ = good_ && bytes <= bytes_.size();
    if (!good_ || bytes == 0) return;
    std::memcpy(to, bytes_.data(), bytes);
    bytes_.remove_prefix(bytes);
  }

  std::string_view bytes_;
  bool good_ = true;
};

}  // namespace leda::solver
