#include "profiles/network_fence.hpp"

#include <cpl_string.h>
#include <cpl_vsi_virtual.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <string_view>
#include <vector>

namespace leda::profiles {
namespace {

/// In memory, parts of files, and the archive that a zipped shapefile is written to.
constexpr std::array<std::string_view, 5> local{"/vsimem/", "/vsisubfile/", "/vsisparse/",
                                                "/vsizip/", "/vsigzip/"};

class Nothing final : public VSIFilesystemHandler {
 public:
  VSIVirtualHandle* Open(const char* /*name*/, const char* /*access*/, bool /*set_error*/,
                         CSLConstList /*options*/) override {
    errno = ENOENT;
    return nullptr;
  }
  int Stat(const char* /*name*/, VSIStatBufL* /*status*/, int /*flags*/) override {
    errno = ENOENT;
    return -1;
  }
};

}  // namespace

void close_network() {
  // GDAL owns what is installed, and destroys it once however often it is installed. What it is
  // installed in place of is GDAL's no more; it is kept, since GDAL itself may still point to it.
  auto* nothing = std::make_unique<Nothing>().release();
  // NOLINTNEXTLINE(*-owning-memory, *-global-variables): it outlives whatever ends the process
  static auto& replaced = *new std::vector<VSIFilesystemHandler*>;
  const CPLStringList prefixes(VSIGetFileSystemsPrefixes());
  for (int i = 0; i < prefixes.size(); ++i) {
    const std::string_view prefix = prefixes[i];
    if (std::find(local.begin(), local.end(), prefix) != local.end()) continue;
    replaced.push_back(VSIFileManager::GetHandler(prefixes[i]));
    VSIFileManager::InstallHandler(prefixes[i], nothing);
  }
}

}  // namespace leda::profiles
