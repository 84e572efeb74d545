// SPDX-License-Identifier: MIT
#include "sim/scene/import.h"

#include <cmath>
#include <csignal>
#include <span>
#include <string>

#include "sim/base/error.h"
#include "sim/scene/import_program.h"
#include "sim/scene/mesh_blob.h"
#include "sim/scene/run_program.h"

namespace bulletnav::sim {
namespace {

[[noreturn]] void FailWithoutAnswer(const std::filesystem::path& file, std::optional<int> signal) {
  if (signal == SIGXCPU || signal == SIGKILL) {
    throw FileError(file, "", "is damaged: reading it does not end; export it again");
  }
  throw FileError(file, "", "is damaged: reading it fails; export or download it again");
}

/// An exception's text, as it was thrown over there: "FILE: what" or "FILE:place: what".
[[noreturn]] void FailAsTold(const std::filesystem::path& file, const std::string& text) {
  const std::string name = file.string();
  const std::size_t end = text.find(": ", name.size());
  if (!text.starts_with(name) || end == std::string::npos) {
    throw FileError(file, "", "cannot be read: " + text);  // a library's, or the standard's
  }
  const std::string place =
      end == name.size() ? "" : text.substr(name.size() + 1, end - name.size() - 1);
  throw FileError(file, place, text.substr(end + 2));
}

ImportedScene Finished(ImportedScene scene, const std::string& name, const ImportOptions& options) {
  const Finish& finish = options.finish;
  if (options.doors) SetDoors(*options.doors, name, &scene.doors, &scene.mesh);
  ApplyFinish(finish, &scene.mesh);
  if (finish.damage != Damage{}) {
    scene.drawn = scene.mesh;
    ApplyDamage(finish.damage, &*scene.drawn);
  }
  return scene;
}

}  // namespace

ImportedScene ImportScene(const std::filesystem::path& file, const ImportOptions& options) {
  if (!(options.scale > 0.0 && std::isfinite(options.scale))) {
    throw Error("the scale of a scene must be positive: metres per unit of the file");
  }
  options.finish.Validate();
  if (options.doors) options.doors->Validate();
  // assimp crashes and hangs on some damaged files, and a library must not take its user with it.
  const EndedProgram reader(ImportProgram(), ToArguments(file, options));
  const std::span<const std::uint8_t> output = reader.output();
  if (output.empty()) FailWithoutAnswer(file, reader.signal());
  const std::span<const std::uint8_t> content = output.first(output.size() - 1);
  switch (static_cast<ImportEnd>(output.back())) {
    case ImportEnd::kScene:
      if (!reader.signal()) return Finished(FromBlob(content), file.filename().string(), options);
      break;
    case ImportEnd::kError:
      FailAsTold(file, std::string(content.begin(), content.end()));
    case ImportEnd::kTooLarge:
      throw FileError(file, "", "asks for more memory than there is; is it damaged?");
  }
  FailWithoutAnswer(file, reader.signal());
}

}  // namespace bulletnav::sim
