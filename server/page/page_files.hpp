#pragma once
// The files of the map page, carried inside the program.

#include <span>
#include <string_view>

namespace leda::server {

struct PageFile {
  std::string_view name;   ///< "page.js"
  std::string_view type;   ///< media type
  std::string_view hash;   ///< of its bytes, for the ETag
  std::string_view bytes;  ///< as they are
  std::string_view gzip;   ///< the same, packed
};

/// Empty where the program was built without Node.js and npm.
std::span<const PageFile> page_files();

/// The file of that name; null where there is none.
inline const PageFile* find_page_file(std::string_view name) {
  for (const PageFile& file : page_files()) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

}  // namespace leda::server
