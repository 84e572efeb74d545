// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "sim/house/furniture.h"

namespace bulletnav::sim::furniture {

/// The catalogue by family, one file each; FindFurniture and AllFurniture put them together.
std::span<const FurnitureKind> Bathroom();
std::span<const FurnitureKind> BathroomFittings();
std::span<const FurnitureKind> Beds();
std::span<const FurnitureKind> Cabinets();
std::span<const FurnitureKind> CeilingLamps();
std::span<const FurnitureKind> Chairs();
std::span<const FurnitureKind> Clinic();
std::span<const FurnitureKind> ClinicBeds();
std::span<const FurnitureKind> Fixtures();
std::span<const FurnitureKind> FloorClutter();
std::span<const FurnitureKind> Hall();
std::span<const FurnitureKind> Hobbies();
std::span<const FurnitureKind> HomeClutter();
std::span<const FurnitureKind> Hotel();
std::span<const FurnitureKind> Industry();
std::span<const FurnitureKind> Kids();
std::span<const FurnitureKind> KitchenAppliances();
std::span<const FurnitureKind> KitchenClutter();
std::span<const FurnitureKind> KitchenRuns();
std::span<const FurnitureKind> Laboratory();
std::span<const FurnitureKind> Lamps();
std::span<const FurnitureKind> Laundry();
std::span<const FurnitureKind> Plants();
std::span<const FurnitureKind> Rugs();
std::span<const FurnitureKind> School();
std::span<const FurnitureKind> Screens();
std::span<const FurnitureKind> Shelves();
std::span<const FurnitureKind> ShopDisplays();
std::span<const FurnitureKind> ShopFittings();
std::span<const FurnitureKind> Sofas();
std::span<const FurnitureKind> Study();
std::span<const FurnitureKind> Tables();
std::span<const FurnitureKind> Tools();
std::span<const FurnitureKind> Toys();
std::span<const FurnitureKind> Vehicles();
std::span<const FurnitureKind> WallArt();
std::span<const FurnitureKind> Windows();
std::span<const FurnitureKind> Workplaces();

}  // namespace bulletnav::sim::furniture
