// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <span>
#include <string>

namespace bulletnav::bench {

/// What people are told that scenes are called, by their files as episodes name them: the file's
/// name without its extension; of files called alike, with as many of the folders they are in as
/// tell them apart ("aws_bookstore/scene"); with all of it where folders do not.
std::map<std::string, std::string> SceneNames(std::span<const std::string> scenes);

/// Of a scene alone, where others are not known: with the folder that it is in, if it says one.
std::string LongSceneName(const std::string& scene);

/// Whether an episode's name has that of its scene in it.
bool NamesScene(const std::string& scene, const std::string& episode);

/// The name of an episode with that of its scene, which drawn episodes have in theirs.
std::string EpisodeName(const std::string& scene, const std::string& episode);

}  // namespace bulletnav::bench
