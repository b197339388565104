/// Layers: what a picture shows.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace wuerfel {

enum class Layer {
  cubes,       ///< cubes, fixed boxes and the ground
  rods,        ///< the rods that keep a cube stiff (Figure 2 of the paper)
  points,      ///< point masses, area proportional to mass (Figure 7)
  sides,       ///< the triangle of Eq. (2) with its sign (Figures 3 and 4)
  normals,     ///< unit normals of the contacts
  forces,      ///< contact and friction forces as arrows
  rod_forces,  ///< rods coloured and thickened by tension or compression
  velocities,  ///< velocities of the cubes as arrows
  trails,      ///< the paths of the centres up to now
  contacts,    ///< touching points
  grid,        ///< lines at round metres
  names,       ///< names of the bodies
  hud,         ///< title, time, energy, scale bar, legend
};

/// A set of layers.
class Layers {
 public:
  constexpr Layers() = default;
  constexpr Layers(std::initializer_list<Layer> layers) {
    for (const Layer layer : layers)
      insert(layer);
  }
  constexpr void insert(Layer layer) { bits_ |= bit(layer); }
  constexpr void erase(Layer layer) { bits_ &= ~bit(layer); }
  constexpr bool has(Layer layer) const { return (bits_ & bit(layer)) != 0; }
  friend constexpr bool operator==(Layers, Layers) = default;

 private:
  static constexpr std::uint32_t bit(Layer layer) {
    return 1U << static_cast<std::uint32_t>(layer);
  }
  std::uint32_t bits_ = 0;
};

constexpr Layers default_layers{Layer::cubes, Layer::forces, Layer::hud};

std::string_view to_string(Layer layer);

/// The names in the order of the enum, with commas.
std::string to_string(Layers layers);

}  // namespace wuerfel
