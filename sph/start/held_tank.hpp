// The tank at rest in which an initial state is prepared.
#pragma once

#include <functional>

#include "sph/scene.hpp"

namespace slosh::sph {

// The tank held at its initial position, with a given velocity and acceleration. `rolls` keeps the
// roll's initial rate and acceleration, which matter in the tank's frame only.
struct HeldTank {
  double velocity = 0, acceleration = 0;
  bool rolls = false;

  Scene scene(Scene scene) const {
    const double place = scene.displacement(0);
    scene.displacement = [place](double) { return place; };
    scene.velocity = [this](double) { return velocity; };
    scene.acceleration = [this](double) { return acceleration; };
    if (scene.roll) {
      const auto held = [this](const std::function<double(double)>& of_time) {
        return [this, value = of_time(0)](double) { return rolls ? value : 0.0; };
      };
      scene.roll->angle = [angle = scene.roll->angle(0)](double) { return angle; };
      scene.roll->rate = held(scene.roll->rate);
      scene.roll->acceleration = held(scene.roll->acceleration);
    }
    return scene;
  }
};

}  // namespace slosh::sph
