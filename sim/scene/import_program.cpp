// SPDX-License-Identifier: MIT
#include "sim/scene/import_program.h"

#include <array>
#include <cstdlib>

#include <dlfcn.h>
#include <unistd.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "bulletnav-import";
constexpr std::size_t kArguments = 6;

std::string UpText(const std::optional<UpAxis>& up) {
  if (!up) return "any";
  return *up == UpAxis::kY ? "y" : "z";
}

std::string Exactly(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%a", value);
  return text.data();
}

/// How they are turned is not the program's business.
std::string DoorsText(const std::optional<DoorSpec>& doors) {
  if (!doors) return "unasked";
  return doors->turns() ? "to turn" : "as built";
}

/// The folder of the program or library that this function is in.
fs::path OwnFolder() {
  Dl_info info = {};
  const bool is_found =
      ::dladdr(reinterpret_cast<const void*>(&OwnFolder), &info) != 0 && info.dli_fname != nullptr;
  std::error_code ignored;
  // A program's own name may be relative to a folder that it has left since.
  const fs::path name = is_found ? fs::path(info.dli_fname) : fs::path();
  if (name.extension() == ".so" || name.string().find(".so.") != std::string::npos) {
    return fs::weakly_canonical(name, ignored).parent_path();
  }
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

/// The build folder that a folder is in; empty if it is in none. Looked for rather than built in,
/// so that what is installed names no place of the machine it was built on.
fs::path BuildFolder(fs::path folder) {
  std::error_code unreadable;
  while (folder.has_relative_path()) {
    if (fs::exists(folder / "CMakeCache.txt", unreadable)) return folder;
    folder = folder.parent_path();
  }
  return {};
}

}  // namespace

std::vector<std::string> ToArguments(const fs::path& file, const ImportOptions& options) {
  return {kImportProtocol,
          file.string(),
          UpText(options.up),
          Exactly(options.scale),
          options.ground_plane ? "plane" : "none",
          DoorsText(options.doors)};
}

ImportRequest FromArguments(std::span<const char* const> arguments) {
  if (arguments.size() != kArguments || arguments[0] != std::string(kImportProtocol)) {
    throw Error(std::string(kName) + " is of another version than the program that calls it");
  }
  ImportRequest request;
  request.file = arguments[1];
  const std::string up = arguments[2];
  if (up == "y") request.options.up = UpAxis::kY;
  if (up == "z") request.options.up = UpAxis::kZ;
  request.options.scale = std::strtod(arguments[3], nullptr);
  request.options.ground_plane = arguments[4] == std::string("plane");
  const std::string doors = arguments[5];
  if (doors != "unasked") request.options.doors.emplace();
  if (doors == "to turn") request.options.doors->state = DoorState::kOpen;
  return request;
}

fs::path ImportProgram() {
  const fs::path own = OwnFolder();
  const std::array<fs::path, 5> places = {
      own / kName, own / "../libexec/bulletnav" / kName, BuildFolder(own) / kName,
      fs::path(BULLETNAV_BUILT_IN) / kName, fs::path(BULLETNAV_LIBEXEC) / kName};
  for (const fs::path& place : places) {
    if (place.is_absolute() && ::access(place.c_str(), X_OK) == 0) return place;
  }
  throw Error("scenes cannot be read: the program " + places[0].string() +
              " is missing; build or install it again");
}

}  // namespace bulletnav::sim
