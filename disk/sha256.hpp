#pragma once
// SHA-256 of texts and files, 64 hex digits.

#include <filesystem>
#include <string>
#include <string_view>

namespace leda::disk {

std::string sha256_of(std::string_view text);

/// 64 hex digits in small letters.
bool is_sha256(std::string_view text);

/// @throws std::runtime_error naming a file that can't be read
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace leda::disk
