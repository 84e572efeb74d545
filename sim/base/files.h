// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bulletnav::sim {

/// The whole file. Throws FileError, with the reason, if it is missing, a directory or unreadable.
std::vector<std::uint8_t> ReadFile(const std::filesystem::path& file);
std::string ReadTextFile(const std::filesystem::path& file);

/// Writes to a temporary name beside `file`, syncs, then renames: a reader sees the old content or
/// the new one, never a part, also after a crash or on a full disk. Makes missing parent folders.
/// Throws FileError if there is no permission or no space; the temporary file is then removed.
void WriteFileAtomically(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);
void WriteFileAtomically(const std::filesystem::path& file, std::string_view text);

/// For libraries that insist on writing a file by name: calls `write` with the temporary name.
void WriteFileAtomically(const std::filesystem::path& file,
                         const std::function<void(const std::filesystem::path&)>& write);

/// Makes `folder` and its parents. Throws FileError if it is a file or cannot be made.
void MakeFolder(const std::filesystem::path& folder);

/// Removes from `folder` the temporary files that processes left which were killed while they
/// wrote. Those of processes that run stay, as does what cannot be removed.
void RemoveLeftovers(const std::filesystem::path& folder);

/// 64-bit FNV-1a: stable names and cache keys, not security.
std::uint64_t Hash64(std::span<const std::uint8_t> bytes);
std::uint64_t Hash64(std::string_view text);

}  // namespace bulletnav::sim
