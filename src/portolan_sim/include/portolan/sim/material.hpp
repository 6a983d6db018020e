// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace portolan::sim {

/// What a surface is made of, as far as light and sound tell.
enum class Material {
  ordinary,  ///< seen by all
  glass,     ///< light passes, sound comes back
  soft,      ///< light comes back, sound is swallowed
};

constexpr std::array<const char*, 3> enum_names(Material) { return {"ordinary", "glass", "soft"}; }

/// What a sensor sends out.
enum class Wave { light, sound };

/// True where the wave goes on behind the surface.
constexpr bool passes(Wave wave, Material material) {
  return wave == Wave::light && material == Material::glass;
}

/// True where some of the wave comes back from the surface.
constexpr bool returns(Wave wave, Material material) {
  return wave == Wave::light ? material != Material::glass : material != Material::soft;
}

}  // namespace portolan::sim
