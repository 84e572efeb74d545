// SPDX-License-Identifier: MIT
#include "sim/import/urdf.h"

#include <algorithm>
#include <cmath>

#include <tinyxml2.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/import/door_joint.h"
#include "sim/import/primitives.h"
#include "sim/import/uri.h"
#include "sim/import/xml_attributes.h"
#include "sim/math/rotation.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;
using Element = tinyxml2::XMLElement;

class Reader : private XmlAttributes {
 public:
  explicit Reader(const std::filesystem::path& file) : XmlAttributes(file), file_(file) {}

  Urdf Read() {
    tinyxml2::XMLDocument document;
    ParseXml(ReadTextFile(file_), file_, &document);
    const Element* robot = document.FirstChildElement("robot");
    if (robot == nullptr) {
      throw FileError(file_, "", "is no URDF: it has no element 'robot'; is it the right file?");
    }
    robot_ = robot;
    for (const Element* e = robot->FirstChildElement("link"); e != nullptr;
         e = e->NextSiblingElement("link")) {
      AddLink(*e);
    }
    if (model_.links.empty()) Fail(*robot, "has no link; is it the right file?");
    for (const Element* e = robot->FirstChildElement("joint"); e != nullptr;
         e = e->NextSiblingElement("joint")) {
      AddJoint(*e);
    }
    SortJoints();
    return std::move(model_);
  }

 private:
  /// Of what has an `origin`: xyz in metres, rpy about the fixed axes x, y and z in radians.
  Eigen::Affine3f Origin(const Element& owner) const {
    Eigen::Affine3f pose = Eigen::Affine3f::Identity();
    const Element* origin = owner.FirstChildElement("origin");
    if (origin == nullptr) return pose;
    if (origin->Attribute("xyz") != nullptr) {
      pose.translation() = Vector(*origin, "xyz").cast<float>();
    }
    if (origin->Attribute("rpy") == nullptr) return pose;
    using Axis = Eigen::Vector3d;
    const Eigen::Vector3d rpy = Vector(*origin, "rpy");
    const Eigen::Matrix3d yaw = RotationAbout<double>(Axis::UnitZ(), rpy.z());
    const Eigen::Matrix3d pitch = RotationAbout<double>(Axis::UnitY(), rpy.y());
    const Eigen::Matrix3d roll = RotationAbout<double>(Axis::UnitX(), rpy.x());
    pose.linear() = (yaw * pitch * roll).cast<float>();
    return pose;
  }

  void AddLink(const Element& element) {
    UrdfLink link;
    link.name = Text(element, "name");
    if (!links_.emplace(link.name, model_.links.size()).second) {
      Fail(element, "there are two links '" + link.name + "'; give them names of their own");
    }
    for (const Element* e = element.FirstChildElement("visual"); e != nullptr;
         e = e->NextSiblingElement("visual")) {
      AddVisual(*e, &link);
    }
    model_.links.push_back(std::move(link));
  }

  void AddVisual(const Element& element, UrdfLink* link) {
    const Element* geometry = element.FirstChildElement("geometry");
    const Element* form = geometry == nullptr ? nullptr : geometry->FirstChildElement();
    if (form == nullptr) Fail(element, "a visual of '" + link->name + "' has no geometry; add it");
    UrdfVisual visual;
    visual.X_LA = Origin(element);
    const std::string type = form->Name();
    if (type == "mesh") {
      ReadMesh(*form, *link, &visual);
    } else if (type == "box") {
      visual.shape = BoxShape(Vector(*form, "size").cast<float>());
    } else if (type == "cylinder") {
      visual.shape = CylinderShape(Positive(*form, "radius"), Positive(*form, "length"));
    } else if (type == "sphere") {
      visual.shape = EllipsoidShape(Vec::Constant(Positive(*form, "radius")));
    } else {
      ++model_.left_out["visuals of other shapes (capsules, planes)"];
      return;
    }
    if (visual.asset.empty()) Paint(element, &visual.shape);
    link->visuals.push_back(std::move(visual));
  }

  void ReadMesh(const Element& form, const UrdfLink& link, UrdfVisual* visual) const {
    const std::string name = Text(form, "filename");
    const auto found = FindByUri(file_.parent_path(), name);
    if (!found) {
      Fail(form, "the mesh '" + name + "' of link '" + link.name +
                     "' is not found from the file's folder; download what is missing, or mend "
                     "the name");
    }
    visual->asset = *found;
    if (form.Attribute("scale") == nullptr) return;
    std::vector<double> scale = Numbers(form, "scale");
    if (scale.size() == 1) scale.assign(3, scale[0]);
    if (scale.size() != 3 || std::count(scale.begin(), scale.end(), 0.0) != 0) {
      Fail(form, "'scale' of 'mesh' is not three numbers other than 0; mend it");
    }
    visual->X_LA.linear() *= Eigen::Vector3d(scale.data()).cast<float>().asDiagonal();
  }

  /// With the visual's colour, or that of the robot's material of the same name.
  void Paint(const Element& visual, SceneMesh* shape) const {
    const Element* material = visual.FirstChildElement("material");
    if (material == nullptr) return;
    const char* const name = material->Attribute("name");
    const Element* known = robot_->FirstChildElement("material");
    while (material->FirstChildElement("color") == nullptr && name != nullptr && known != nullptr) {
      if (known->Attribute("name", name) != nullptr) material = known;
      known = known->NextSiblingElement("material");
    }
    const Element* color = material->FirstChildElement("color");
    if (color == nullptr) return;
    const std::vector<double> rgba = Numbers(*color, "rgba", 4);
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = std::min(std::max(rgba[i], 0.0), 1.0);
      shape->materials[0].base_color[i] = static_cast<std::uint8_t>(std::lround(255.0 * part));
    }
  }

  std::size_t LinkOf(const Element& joint, const char* end) const {
    const Element* element = joint.FirstChildElement(end);
    if (element == nullptr) {
      Fail(joint, "joint '" + Text(joint, "name") + "' has no " + end + "; add it");
    }
    const std::string name = Text(*element, "link");
    const auto found = links_.find(name);
    if (found == links_.end()) Fail(*element, "there is no link '" + name + "'; mend the name");
    return found->second;
  }

  UrdfJointType TypeOf(const Element& joint) const {
    const std::string type = Text(joint, "type");
    std::string known;
    for (const auto& [name, value] : EnumNames<UrdfJointType>::kNames) {
      if (type == name) return value;
      known += (known.empty() ? "" : ", ") + std::string(name);
    }
    Fail(joint, "'" + type + "' is no type of joint: " + known);
  }

  void AddJoint(const Element& element) {
    UrdfJoint joint;
    joint.name = Text(element, "name");
    joint.type = TypeOf(element);
    joint.parent = LinkOf(element, "parent");
    joint.child = LinkOf(element, "child");
    joint.X_PJ = Origin(element);
    for (const UrdfJoint& other : model_.joints) {
      if (other.name == joint.name) Fail(element, "there are two joints '" + joint.name + "'");
      if (other.child != joint.child) continue;
      Fail(element, "link '" + model_.links[joint.child].name + "' hangs on two joints, '" +
                        other.name + "' and '" + joint.name + "'; take one out");
    }
    if (joint.moves()) {
      ReadMotion(element, &joint);
    } else if (joint.type != UrdfJointType::kFixed) {
      ++model_.left_out["joints that are not drawn moved (planar, floating, spherical)"];
    }
    model_.joints.push_back(std::move(joint));
  }

  void ReadMotion(const Element& element, UrdfJoint* joint) const {
    if (const Element* axis = element.FirstChildElement("axis")) {
      const Eigen::Vector3d along = Vector(*axis, "xyz");
      if (!(along.norm() > 1e-6)) Fail(*axis, "the axis has no length; mend it");
      joint->axis = along.normalized().cast<float>();
    }
    if (const Element* angle = element.FirstChildElement(kAngleAtZero)) {
      joint->angle_at_zero = Number(*angle, "value");
    }
    if (joint->type == UrdfJointType::kContinuous) return;
    const Element* limit = element.FirstChildElement("limit");
    if (limit == nullptr) {
      Fail(element, "joint '" + joint->name + "' has no limit; add it, or call it continuous");
    }
    const bool has_lower = limit->Attribute("lower") != nullptr;
    const bool has_upper = limit->Attribute("upper") != nullptr;
    if (has_lower) joint->lower = Number(*limit, "lower");
    if (has_upper) joint->upper = Number(*limit, "upper");
    // As Bullet takes them, and habitat-sim with it.
    const bool is_free = (!has_lower && !has_upper) || joint->lower > joint->upper;
    if (is_free && joint->type == UrdfJointType::kRevolute)
      joint->type = UrdfJointType::kContinuous;
  }

  void SortJoints() {
    std::map<std::size_t, std::map<std::string, UrdfJoint*>> below;
    std::vector<bool> is_root(model_.links.size(), true);
    for (UrdfJoint& joint : model_.joints) {
      below[joint.parent][joint.name] = &joint;
      is_root[joint.child] = false;
    }
    std::vector<UrdfJoint> sorted;
    std::vector<std::size_t> open;  // links whose joints come next, the nearest last
    for (std::size_t root = 0; root < is_root.size(); ++root) {
      if (is_root[root]) open.push_back(root);
    }
    std::reverse(open.begin(), open.end());
    std::map<std::size_t, UrdfJoint*> above;
    while (!open.empty()) {
      const std::size_t link = open.back();
      open.pop_back();
      if (const auto joint = above.find(link); joint != above.end()) {
        sorted.push_back(std::move(*joint->second));
      }
      auto& joints = below[link];
      for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
        const std::size_t child = joint->second->child;
        above[child] = joint->second;
        open.push_back(child);
      }
    }
    if (sorted.size() != model_.joints.size()) {
      throw FileError(file_, "", "its joints run in a circle; take one of them out");
    }
    model_.joints = std::move(sorted);
  }

  const std::filesystem::path& file_;
  const Element* robot_ = nullptr;
  std::map<std::string, std::size_t> links_;
  Urdf model_;
};

}  // namespace

Urdf ReadUrdf(const std::filesystem::path& file) {
  return Reader(file).Read();
}

}  // namespace bulletnav::sim
