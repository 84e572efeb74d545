// SPDX-License-Identifier: MIT
#include "sim/import/gazebo_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include <sdf/sdf.hh>

#include "sim/base/error.h"
#include "sim/import/cpu_time.h"
#include "sim/import/door_joint.h"
#include "sim/import/gazebo_files.h"
#include "sim/import/primitives.h"
#include "sim/scene/glass.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;
using Pose = ignition::math::Pose3d;

// libsdformat takes some milliseconds a model; a large warehouse has thousands.
constexpr int kSecondsForSdf = 60;

Vec ToEigen(const ignition::math::Vector3d& v) {
  return Eigen::Vector3d(v.X(), v.Y(), v.Z()).cast<float>();
}

/// Onto a fine grid, where the last bits of the sines that libsdformat calls, which are not the
/// same on all processors, make no difference.
float Rounded(double value) {
  constexpr double kSteps = 1 << 28;
  return static_cast<float>(std::nearbyint(value * kSteps) / kSteps);
}

Eigen::Affine3f ToEigen(const Pose& pose) {
  const auto& q = pose.Rot();
  const Eigen::Matrix3d rotation =
      Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized().toRotationMatrix();
  Eigen::Affine3f rounded = Eigen::Affine3f::Identity();
  rounded.linear() = rotation.unaryExpr([](double v) {
    return Rounded(v);
  });
  rounded.translation() =
      Vec(Rounded(pose.Pos().X()), Rounded(pose.Pos().Y()), Rounded(pose.Pos().Z()));
  return rounded;
}

/// Models that Gazebo brings itself, whose absence no one minds.
bool IsGazebosOwn(const std::string& message) {
  return message.find("model://sun]") != std::string::npos ||
         message.find("model://ground_plane]") != std::string::npos;
}

class WorldReader {
 public:
  explicit WorldReader(const std::filesystem::path& file)
      : file_(file), folders_(ModelFolders(file)) {}

  SceneParts Read() {
    AllowCpuSeconds(kSecondsForSdf);
    RequireNoCycle(folders_, file_);
    const auto find = [this](const std::string& uri) {
      const auto found = FindModelFile(folders_, file_, uri);
      return found ? found->string() : "";
    };
    sdf::Console::Instance()->SetQuiet(true);
    sdf::setFindCallback(find);  // models within models are looked for by this
    sdf::ParserConfig config;
    config.SetFindCallback(find);
    sdf::Root root;
    Check(root.Load(file_.string(), config));
    scene_.up = UpAxis::kZ;
    AddAll(root);
    for (const auto& [what, count] : left_out_) {
      scene_.skipped.push_back(std::to_string(count) + " " + what);
    }
    if (scene_.parts.empty()) throw FileError(file_, "", "shows nothing: no model has a visual");
    return std::move(scene_);
  }

 private:
  void Check(const sdf::Errors& errors) {
    for (const sdf::Error& error : errors) {
      if (IsGazebosOwn(error.Message())) {
        ++left_out_["models of Gazebo's own that are not there (sun, ground_plane)"];
        continue;
      }
      std::string place = error.LineNumber() ? std::to_string(*error.LineNumber()) : "";
      std::string what = error.Message();
      const std::string other = error.FilePath().value_or(file_.string());
      if (other != file_.string()) {
        place.clear();
        what.insert(0, other + ": ");
      }
      for (char& c : what) c = c == '\n' ? ' ' : c;
      throw FileError(file_, place,
                      what +
                          "; mend it, or put the model beside the world or into "
                          "a folder of GZ_SIM_RESOURCE_PATH");
    }
  }

  void AddAll(const sdf::Root& root) {
    if (root.Model() != nullptr) AddModel(*root.Model(), Eigen::Affine3f::Identity(), "");
    for (std::uint64_t w = 0; w < root.WorldCount(); ++w) {
      const sdf::World& world = *root.WorldByIndex(w);
      for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
        AddModel(*world.ModelByIndex(i), PoseOf(*world.ModelByIndex(i)), "");
      }
      left_out_["actors"] += static_cast<int>(world.ActorCount());
    }
    std::erase_if(left_out_, [](const auto& entry) {
      return entry.second == 0;
    });
  }

  /// In what holds it.
  template <class Thing>
  Eigen::Affine3f PoseOf(const Thing& thing) {
    Pose pose;
    Check(thing.SemanticPose().Resolve(pose));
    return ToEigen(pose);
  }

  /// Links that hang on an upright hinge and are doors by a name, by their names.
  std::map<std::string, int> AddDoors(const sdf::Model& model, const Eigen::Affine3f& X_WM) {
    std::map<std::string, int> doors;
    for (std::uint64_t j = 0; j < model.JointCount(); ++j) {
      const sdf::Joint& joint = *model.JointByIndex(j);
      if (joint.Type() != sdf::JointType::REVOLUTE || joint.Axis() == nullptr) continue;
      std::string link;
      Check(joint.ResolveChildLink(link));
      if (!NamesDoor(model.Name() + " " + joint.Name() + " " + link)) continue;
      const std::optional<DoorLeaf> door = DoorOf(joint, X_WM);
      if (!door || !doors.emplace(link, static_cast<int>(scene_.doors.size())).second) continue;
      scene_.doors.push_back(*door);
    }
    AddFixed(model, &doors);
    return doors;
  }

  /// Links that are fixed to a door, as handles are, turn with it.
  void AddFixed(const sdf::Model& model, std::map<std::string, int>* doors) {
    for (std::size_t before = 0; before != doors->size();) {
      before = doors->size();
      for (std::uint64_t j = 0; j < model.JointCount(); ++j) {
        const sdf::Joint& joint = *model.JointByIndex(j);
        if (joint.Type() == sdf::JointType::FIXED) AddChild(joint, doors);
      }
    }
  }

  void AddChild(const sdf::Joint& joint, std::map<std::string, int>* doors) {
    std::string parent;
    std::string child;
    Check(joint.ResolveParentLink(parent));
    Check(joint.ResolveChildLink(child));
    const auto door = doors->find(parent);
    if (door != doors->end()) doors->emplace(child, door->second);
  }

  /// Absent where the axis is not upright. Poses in the world are those of joints at 0.
  std::optional<DoorLeaf> DoorOf(const sdf::Joint& joint, const Eigen::Affine3f& X_WM) {
    Pose pose;
    Check(joint.SemanticPose().Resolve(pose, "__model__"));
    ignition::math::Vector3d axis;
    Check(joint.Axis()->ResolveXyz(axis, "__model__"));
    TurningJoint turning;
    turning.hinge = (X_WM * ToEigen(pose)).translation();
    turning.axis = (X_WM.linear() * ToEigen(axis)).normalized().unaryExpr([](float v) {
      return Rounded(double{v});
    });
    turning.lower = joint.Axis()->Lower();
    turning.upper = joint.Axis()->Upper();
    const sdf::ElementPtr element = joint.Element();
    if (element->HasElement(kAngleAtZero)) {
      turning.angle_at_zero = element->GetElement(kAngleAtZero)->Get<double>("", 0.0).first;
    }
    return LeafOn(turning, Vec::UnitZ());
  }

  void AddModel(const sdf::Model& model, const Eigen::Affine3f& X_WM, const std::string& above) {
    const std::string name = above + model.Name();
    const std::map<std::string, int> doors = AddDoors(model, X_WM);
    for (std::uint64_t l = 0; l < model.LinkCount(); ++l) {
      const sdf::Link& link = *model.LinkByIndex(l);
      ScenePart part;
      part.place = " visual '" + name + "::" + link.Name() + "::";
      part.object = {model.Name(), name, ""};
      part.X_WA = X_WM * PoseOf(link);
      if (const auto door = doors.find(link.Name()); door != doors.end()) {
        part.door = door->second;
        part.object = {"door", name + "::" + link.Name(), ""};
      }
      AddVisuals(link, part);
    }
    for (std::uint64_t m = 0; m < model.ModelCount(); ++m) {
      const sdf::Model& nested = *model.ModelByIndex(m);
      AddModel(nested, X_WM * PoseOf(nested), name + "::");
    }
  }

  /// `like`: with the link's pose and the beginning of its visuals' names.
  void AddVisuals(const sdf::Link& link, const ScenePart& like) {
    for (std::uint64_t v = 0; v < link.VisualCount(); ++v) {
      const sdf::Visual& visual = *link.VisualByIndex(v);
      ScenePart part = like;
      part.place += visual.Name() + "'";
      part.X_WA = like.X_WA * PoseOf(visual);
      if (AddShape(visual, &part)) scene_.parts.push_back(std::move(part));
    }
  }

  bool AddShape(const sdf::Visual& visual, ScenePart* part) {
    const sdf::Geometry& shape = *visual.Geom();
    if (const sdf::Mesh* mesh = shape.MeshShape()) {
      AddMesh(*mesh, part);
      return true;
    }
    if (const sdf::Box* box = shape.BoxShape()) {
      part->mesh = BoxShape(ToEigen(box->Size()));
    } else if (const sdf::Cylinder* cylinder = shape.CylinderShape()) {
      part->mesh = CylinderShape(static_cast<float>(cylinder->Radius()),
                                 static_cast<float>(cylinder->Length()));
    } else if (const sdf::Sphere* sphere = shape.SphereShape()) {
      part->mesh = EllipsoidShape(Vec::Constant(static_cast<float>(sphere->Radius())));
    } else if (const sdf::Ellipsoid* ellipsoid = shape.EllipsoidShape()) {
      part->mesh = EllipsoidShape(ToEigen(ellipsoid->Radii()));
    } else if (const sdf::Plane* plane = shape.PlaneShape()) {
      part->mesh = PlaneShape(Eigen::Vector2d(plane->Size().X(), plane->Size().Y()).cast<float>());
      part->ends_with_scene = true;
      part->X_WA.linear() *=
          Eigen::Quaternionf::FromTwoVectors(Vec::UnitZ(), ToEigen(plane->Normal()))
              .toRotationMatrix();
    } else {
      ++left_out_["visuals of other shapes (capsules, heightmaps, polylines)"];
      return false;
    }
    if (const sdf::Material* material = visual.Material()) Paint(*material, &part->mesh);
    if (IsSeeThrough(1.0 - double{visual.Transparency()})) MarkSeeThrough(&part->mesh.materials[0]);
    return true;
  }

  static void Paint(const sdf::Material& material, SceneMesh* mesh) {
    // A script (Gazebo/Wood) without a colour stays white.
    if (!material.Element()->HasElement("diffuse")) return;
    const ignition::math::Color& color = material.Diffuse();
    const std::array<float, 3> rgb = {color.R(), color.G(), color.B()};
    for (std::size_t i = 0; i < 3; ++i) {
      mesh->materials[0].base_color[i] =
          static_cast<std::uint8_t>(std::lround(255.0f * std::min(std::max(rgb[i], 0.0f), 1.0f)));
    }
  }

  void AddMesh(const sdf::Mesh& mesh, ScenePart* part) {
    const auto found = FindModelFile(folders_, mesh.FilePath(), mesh.Uri());
    if (!found) {
      throw FileError(file_, part->place,
                      "its mesh '" + mesh.Uri() +
                          "' is not found; put the model beside the world "
                          "or into a folder of GZ_SIM_RESOURCE_PATH");
    }
    part->asset = *found;
    part->keeps_axes = true;
    part->X_WA.linear() *= ToEigen(mesh.Scale()).asDiagonal();
    if (!mesh.Submesh().empty()) ++left_out_["choices of a submesh: the whole mesh is drawn"];
  }

  const std::filesystem::path& file_;
  std::vector<std::filesystem::path> folders_;
  std::map<std::string, int> left_out_;
  SceneParts scene_;
};

}  // namespace

SceneParts ReadGazeboWorld(const std::filesystem::path& file) {
  return WorldReader(file).Read();
}

}  // namespace bulletnav::sim
