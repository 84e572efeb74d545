// SPDX-License-Identifier: MIT
#include "sim/scene/export_doors.h"

#include <fmt/format.h>

namespace bulletnav::sim {
namespace {

constexpr const char* kNamespace = "xmlns:bulletnav=\"urn:bulletnav\"";

/// From the joint's own 0; exact, so that what is read back is the same float.
double Less(float angle, float zero) {
  return double{angle} - double{zero};
}

}  // namespace

std::string SdfDoor(const ExportedDoor& door) {
  const DoorLeaf& leaf = door.leaf;
  const Eigen::Vector3f& p = leaf.hinge;
  const Eigen::Vector3f& a = leaf.axis;
  const std::string form = fmt::format(
      "<pose>0 0 0 1.5707963267948966 0 0</pose><geometry><mesh><uri>{}</uri></mesh></geometry>",
      door.mesh);
  return fmt::format(
      "    <model name=\"{}\" {}>\n"
      "      <pose>{} {} {} 0 0 0</pose>\n"
      "      <link name=\"leaf\">\n"
      "        <visual name=\"visual\">{}</visual>\n"
      "        <collision name=\"collision\">{}</collision>\n"
      "      </link>\n"
      "      <joint name=\"door_hinge\" type=\"revolute\">\n"
      "        <parent>world</parent>\n"
      "        <child>leaf</child>\n"
      "        <axis>\n"
      "          <xyz>{} {} {}</xyz>\n"
      "          <limit><lower>{}</lower><upper>{}</upper></limit>\n"
      "        </axis>\n"
      "        <bulletnav:angle>{}</bulletnav:angle>\n"
      "      </joint>\n"
      "    </model>\n",
      door.name, kNamespace, p.x(), -p.z() + 0.0f, p.y(), form, form, a.x(), -a.z() + 0.0f, a.y(),
      Less(leaf.shut_angle, leaf.angle), Less(leaf.open_angle, leaf.angle), double{leaf.angle});
}

std::string UrdfDoor(const ExportedDoor& door) {
  const DoorLeaf& leaf = door.leaf;
  const std::string form = fmt::format("<geometry><mesh filename=\"{}\"/></geometry>", door.mesh);
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<robot name=\"{}\" {}>\n"
      "  <link name=\"root\"/>\n"
      "  <joint name=\"door_hinge\" type=\"revolute\">\n"
      "    <parent link=\"root\"/>\n"
      "    <child link=\"leaf\"/>\n"
      "    <axis xyz=\"{} {} {}\"/>\n"
      "    <limit lower=\"{}\" upper=\"{}\" effort=\"100\" velocity=\"10\"/>\n"
      "    <bulletnav:angle value=\"0\"/>\n"
      "  </joint>\n"
      "  <link name=\"leaf\">\n"
      "    <inertial>\n"
      "      <mass value=\"20\"/>\n"
      "      <inertia ixx=\"5\" ixy=\"0\" ixz=\"0\" iyy=\"5\" iyz=\"0\" izz=\"5\"/>\n"
      "    </inertial>\n"
      "    <visual>{}</visual>\n"
      "    <collision>{}</collision>\n"
      "  </link>\n"
      "</robot>\n",
      door.name, kNamespace, leaf.axis.x(), leaf.axis.y(), leaf.axis.z(), leaf.shut_angle,
      leaf.open_angle, form, form);
}

}  // namespace bulletnav::sim
