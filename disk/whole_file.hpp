#pragma once
// Texts as files that appear whole or not at all. What fails throws FileError.

#include <exception>
#include <filesystem>
#include <string_view>

#include "disk/new_file.hpp"

namespace leda::disk {

/// Writes a file under a temporary name beside it, then renames: readers see all or nothing.
void write_whole(const std::filesystem::path& file, std::string_view text);

/// The same, and it is on the disk when this returns: it outlives a power cut.
void write_durably(const std::filesystem::path& file, std::string_view text,
                   std::string_view more = "");

/// Adds to the end of a file, which is made where it is missing.
void append_to_file(const std::filesystem::path& file, std::string_view text,
                    std::string_view more = "");

/// Whether an error tells of a full disk, a used-up quota or a limit on the size of files. HDF5,
/// SQLite and the standard library tell it in the system's words, each in an exception of its own.
bool tells_of_full_disk(const std::exception& error);

}  // namespace leda::disk
